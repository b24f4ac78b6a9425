// Bounds are drawn in their true shape: the edges of boxes and k-DOPs are where particles and directions put them.

#include <gmock/gmock.h>

#include <Eigen/LU>
#include <algorithm>
#include <optional>

#include "drape/bounds/dop_axes.h"
#include "drape/bounds/obb.h"
#include "drape/bounds/quadtree_nodes.h"
#include "drawn_scene.h"
#include "expected_picture.h"

namespace drape::test {
namespace {

constexpr int width = 1280, height = 720, bounds_margin = 4, level = 1, all_levels = 30;

/// The points p with normal . p <= distance.
struct HalfSpace {
    Vec3 normal;
    Real distance;
};

struct Edge {
    Vec3 from, to;
};

/// The edges of what half spaces have in common: its corners are where three of their planes meet and no other half
/// space ends before; an edge runs between two corners that have two planes in common.
std::vector<Edge> edges_of(const std::vector<HalfSpace>& spaces) {
    struct Corner {
        Vec3 place;
        std::array<std::size_t, 3> planes;
    };
    std::vector<Corner> corners;
    for (std::size_t a = 0; a < spaces.size(); ++a) {
        for (std::size_t b = a + 1; b < spaces.size(); ++b) {
            for (std::size_t c = b + 1; c < spaces.size(); ++c) {
                Eigen::Matrix3d normals;
                normals << spaces[a].normal, spaces[b].normal, spaces[c].normal;
                if (std::abs(normals.determinant()) < 1e-9) continue;
                const Vec3 distances(spaces[a].distance, spaces[b].distance, spaces[c].distance);
                const Vec3 place = normals.transpose().inverse() * distances;
                const bool within = std::ranges::all_of(
                    spaces, [&](const HalfSpace& s) { return s.normal.dot(place) <= s.distance + 1e-9; });
                if (within) corners.push_back({place, {a, b, c}});
            }
        }
    }
    std::vector<Edge> edges;
    for (std::size_t m = 0; m < corners.size(); ++m) {
        for (std::size_t n = m + 1; n < corners.size(); ++n) {
            const auto shared = std::ranges::count_if(corners[m].planes, [&](std::size_t plane) {
                return std::ranges::find(corners[n].planes, plane) != corners[n].planes.end();
            });
            if (shared == 2) edges.push_back({corners[m].place, corners[n].place});
        }
    }
    return edges;
}

/// The half spaces about particles along some of the directions of k-DOPs.
std::vector<HalfSpace> dop_about(const Patch& patch, std::span<const int> numbers) {
    std::vector<HalfSpace> spaces;
    for (const int number : numbers) {
        const auto& axis = dop_axes[static_cast<std::size_t>(number)];
        for (const int side : {-1, 1}) {
            HalfSpace space{side * Vec3(axis[0], axis[1], axis[2]), -1e9};
            for (int p = 0; p < patch.particles(); ++p) {
                const Vec3 place = patch.at(p % patch.columns, p / patch.columns);
                space.distance = std::max(space.distance, space.normal.dot(place));
            }
            spaces.push_back(space);
        }
    }
    return spaces;
}

std::vector<HalfSpace> obb_about(const Patch& patch) {
    const Obb box = Obb::fit(patch);
    std::vector<HalfSpace> spaces;
    for (int k = 0; k < 3; ++k) {
        const Vec3 axis = box.axes.col(k);
        spaces.push_back({axis, box.high[k] + axis.dot(box.origin)});
        spaces.push_back({-axis, -box.low[k] - axis.dot(box.origin)});
    }
    return spaces;
}

/// The edges of all nodes of a level, or of all levels.
std::vector<Edge> expected_edges(VolumeKind volume, const Grid& grid, const Points& x, int shown) {
    std::vector<Edge> edges;
    for (const QuadtreeNode& node : make_quadtree_nodes(grid, ContactSettings().leaf_cells)) {
        if (node.level != shown && shown != all_levels) continue;
        const Patch patch = patch_of(grid, node, x);
        const auto of_node = edges_of(volume == VolumeKind::Obb      ? obb_about(patch)
                                      : volume == VolumeKind::Kdop14 ? dop_about(patch, dop_numbers<14>)
                                      : volume == VolumeKind::Kdop18 ? dop_about(patch, dop_numbers<18>)
                                      : volume == VolumeKind::Kdop26 ? dop_about(patch, dop_numbers<26>)
                                                                     : dop_about(patch, dop_numbers<6>));
        edges.insert(edges.end(), of_node.begin(), of_node.end());
    }
    return edges;
}

class BoundsPicture : public testing::Test {
protected:
    void show(VolumeKind volume, int shown = level) {
        scene_.emplace("hang", 0.4,
                       std::vector{"contact.volume=" + name_of(volume), "view.level=" + std::to_string(shown),
                                   std::string("view.bounds=true")});
        with_ = picture_of(scene_->view, width, height);
        scene_->settings.view.bounds = false;
        without_ = picture_of(scene_->view, width, height);
    }

    [[nodiscard]] bool drawn_at(int x, int y) const {
        for (int channel = 0; channel < 3; ++channel) {
            if (std::abs(with_.pixel(x, y)[channel] - without_.pixel(x, y)[channel]) > 6) return true;
        }
        return false;
    }

    /// Visits the pixels of edges that are in the picture, each with its depth.
    template <class Visit>
    void for_each_place(const std::vector<Edge>& edges, Visit visit) const {
        const ExpectedPicture expected(scene_->view, width, height);
        for (const Edge& edge : edges) {
            for (int step = 0; step <= 1000; ++step) {
                const auto place = expected.project(edge.from + (edge.to - edge.from) * (step / Real(1000)));
                const int x = static_cast<int>(place.x), y = static_cast<int>(place.y);
                const bool inside =
                    x >= bounds_margin && y >= bounds_margin && x < width - bounds_margin && y < height - bounds_margin;
                if (inside) visit(x, y, place.depth);
            }
        }
    }

    /// What is wrong with the lines beside the cloth, where nothing hides them: how many pixels of the edges have no
    /// line, and how many pixels have a line and no edge.
    [[nodiscard]] std::vector<std::string> complaints(VolumeKind volume, Real larger = 1, int shown = level) {
        const ExpectedPicture expected(scene_->view, width, height);
        const ClothView& cloth = scene_->cloth();
        std::vector<bool> edge_near(static_cast<std::size_t>(width) * height);
        int samples = 0, missing = 0, lines = 0, stray = 0;
        for_each_place(expected_edges(volume, cloth.model.grid, larger * cloth.x, shown), [&](int x, int y, double) {
            bool drawn = false;
            for (int j = y - 2; j <= y + 2; ++j) {
                for (int i = x - 2; i <= x + 2; ++i) {
                    edge_near[static_cast<std::size_t>(j * width + i)] = true;
                    drawn = drawn || (std::abs(i - x) < 2 && std::abs(j - y) < 2 && drawn_at(i, j));
                }
            }
            if (!expected.surely(Seen::Nothing, x, y, bounds_margin)) return;
            ++samples;
            missing += !drawn;
        });
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                if (!drawn_at(x, y) || !expected.surely(Seen::Nothing, x, y, bounds_margin)) continue;
                ++lines;
                stray += !edge_near[static_cast<std::size_t>(y * width + x)];
            }
        }
        std::vector<std::string> all;
        if (samples < 1000) all.push_back("too little to see");
        if (missing * 50 > samples)
            all.push_back("missing: " + std::to_string(missing) + " of " + std::to_string(samples));
        if (stray * 50 > lines) all.push_back("stray: " + std::to_string(stray) + " of " + std::to_string(lines));
        return all;
    }

    /// What part of the edges behind the cloth is drawn nevertheless.
    [[nodiscard]] double part_seen_through(VolumeKind volume) {
        const ExpectedPicture expected(scene_->view, width, height);
        const ClothView& cloth = scene_->cloth();
        int samples = 0, drawn = 0;
        for_each_place(expected_edges(volume, cloth.model.grid, cloth.x, level), [&](int x, int y, double depth) {
            if (expected.at(x, y) == Seen::Nothing || depth < expected.depth(x, y) + 0.02) return;
            ++samples;
            drawn += drawn_at(x, y) || drawn_at(x - 1, y) || drawn_at(x, y - 1);
        });
        EXPECT_GT(samples, 500);
        return drawn / static_cast<double>(samples);
    }

    std::optional<DrawnScene> scene_;
    Image with_, without_;
};

class EdgesPicture : public BoundsPicture, public testing::WithParamInterface<VolumeKind> {};

constexpr VolumeKind with_edges[] = {VolumeKind::Aabb,   VolumeKind::Kdop6,  VolumeKind::Kdop14,
                                     VolumeKind::Kdop18, VolumeKind::Kdop26, VolumeKind::Obb};

TEST_P(EdgesPicture, ShowsTheEdgesOfEachNode) {
    show(GetParam());
    EXPECT_THAT(complaints(GetParam()), testing::IsEmpty());
    EXPECT_THAT(complaints(GetParam(), Real(1.02)), testing::SizeIs(2)) << "nodes two percent off";
}

const auto name_of_volume = [](const auto& one) { return name_of(one.param); };
INSTANTIATE_TEST_SUITE_P(One, EdgesPicture, testing::Values(VolumeKind::Obb), name_of_volume);
INSTANTIATE_TEST_SUITE_P(Nightly, EdgesPicture, testing::ValuesIn(with_edges), name_of_volume);

TEST_F(BoundsPicture, ShowsAllLevelsPastTheFinestAndWhatIsBehindTheCloth) {
    show(VolumeKind::Aabb, all_levels);
    EXPECT_THAT(complaints(VolumeKind::Aabb, 1, all_levels), testing::IsEmpty());
    show(VolumeKind::Aabb);
    EXPECT_THAT(complaints(VolumeKind::Aabb, 1, all_levels), testing::SizeIs(1)) << "one level is not all";
    EXPECT_GT(part_seen_through(VolumeKind::Aabb), 0.9);
}

TEST_F(BoundsPicture, IsRefusedIfADirectionIsLostOrOtherVolumesAreDrawn) {
    show(VolumeKind::Kdop18);
    EXPECT_THAT(complaints(VolumeKind::Kdop26), testing::SizeIs(testing::Ge(1)));
    EXPECT_THAT(complaints(VolumeKind::Kdop14), testing::SizeIs(2));
    show(VolumeKind::Sphere);
    EXPECT_THAT(complaints(VolumeKind::Obb), testing::SizeIs(2));
}

}  // namespace
}  // namespace drape::test
