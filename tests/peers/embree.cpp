// Embree, always single precision, one thread. With a ball: a tree of wide nodes over triangles, or over quads, which a
// cell's two triangles fit into. Of pairs: rtcCollide of a scene with itself, whose triangles are a geometry of the
// user's, as in Embree's tutorial "collide".

#include <rtcore.h>

#include "ball_race.h"
#include "drape/base/input_error.h"
#include "pair_race.h"

namespace drape::peers {
namespace {

/// A scene of one geometry that moves.
struct MovingScene {
    RTCDevice device;
    RTCScene scene;
    RTCGeometry geometry;

    MovingScene(RTCGeometryType type, RTCBuildQuality quality, RTCSceneFlags flags)
        : device(rtcNewDevice("threads=1")) {
        if (device == nullptr) throw RunError("Embree does not start");
        scene = rtcNewScene(device);
        rtcSetSceneFlags(scene, static_cast<RTCSceneFlags>(RTC_SCENE_FLAG_DYNAMIC | flags));
        rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_LOW);
        geometry = rtcNewGeometry(device, type);
        rtcSetGeometryBuildQuality(geometry, quality);
        rtcAttachGeometry(scene, geometry);
    }
    ~MovingScene() {
        rtcReleaseGeometry(geometry);
        rtcReleaseScene(scene);
        rtcReleaseDevice(device);
    }
    MovingScene(const MovingScene&) = delete;
    MovingScene& operator=(const MovingScene&) = delete;

    void commit() const {
        rtcCommitGeometry(geometry);
        rtcCommitScene(scene);
    }
};

enum class Shape { Triangles, Quads };

class EmbreeTree final : public BallPeer {
public:
    EmbreeTree(std::string name, const Motion& motion, Shape shape, RTCBuildQuality quality)
        : BallPeer(std::move(name), motion, Real(std::numeric_limits<float>::epsilon())),
          shape_(shape),
          // Compact, so that the leaves hold no copies of the corners, which makes the refit of triangles twice as fast
          tree_(shape == Shape::Quads ? RTC_GEOMETRY_TYPE_QUAD : RTC_GEOMETRY_TYPE_TRIANGLE, quality,
                RTC_SCENE_FLAG_COMPACT),
          corners_(
              static_cast<float*>(rtcSetNewGeometryBuffer(tree_.geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                          3 * sizeof(float), static_cast<std::size_t>(x_.rows())))) {
        const Grid& grid = motion.grid;
        std::vector<int> indices;
        if (shape == Shape::Triangles) {
            for (const auto& triangle : motion.corners) indices.insert(indices.end(), triangle.begin(), triangle.end());
        } else {
            for (int cell = 0; cell < grid.cells(); ++cell) {
                const int a = grid.cell_corner(cell);
                indices.insert(indices.end(), {a, a + grid.nx, a + grid.nx + 1, a + 1});
            }
        }
        const std::size_t corners = shape == Shape::Quads ? 4 : 3;
        auto* const buffer = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
            tree_.geometry, RTC_BUFFER_TYPE_INDEX, 0, shape == Shape::Quads ? RTC_FORMAT_UINT4 : RTC_FORMAT_UINT3,
            corners * sizeof(unsigned), indices.size() / corners));
        std::copy(indices.begin(), indices.end(), buffer);
        take_corners();
        tree_.commit();
    }

    void update() override {
        take_corners();
        rtcUpdateGeometryBuffer(tree_.geometry, RTC_BUFFER_TYPE_VERTEX, 0);
        tree_.commit();
    }

private:
    void list_candidates(const Ball& ball, std::vector<int>& triangles) override {
        RTCPointQuery query{};
        query.x = static_cast<float>(ball.centre[0]);
        query.y = static_cast<float>(ball.centre[1]);
        query.z = static_cast<float>(ball.centre[2]);
        query.radius = static_cast<float>(ball.radius);
        RTCPointQueryContext context;
        rtcInitPointQueryContext(&context);
        rtcPointQuery(tree_.scene, &query, &context, shape_ == Shape::Quads ? collect_quad : collect_triangle,
                      &triangles);
    }

    void take_corners() {
        using FloatRows = Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor>;
        Eigen::Map<FloatRows>(corners_, x_.rows(), 3) = x_.cast<float>();
    }

    static bool collect_triangle(RTCPointQueryFunctionArguments* found) {
        static_cast<std::vector<int>*>(found->userPtr)->push_back(static_cast<int>(found->primID));
        return false;
    }

    static bool collect_quad(RTCPointQueryFunctionArguments* found) {
        const int first = 2 * static_cast<int>(found->primID);
        auto& triangles = *static_cast<std::vector<int>*>(found->userPtr);
        triangles.push_back(first);
        triangles.push_back(first + 1);
        return false;
    }

    Shape shape_;
    MovingScene tree_;
    float* corners_;  ///< Embree's: x, y, z of each particle
};

class EmbreePairs final : public PairMethod {
public:
    EmbreePairs(std::string name, const Sheets& sheets, RTCBuildQuality quality)
        : PairMethod(std::move(name), sheets), tree_(RTC_GEOMETRY_TYPE_USER, quality, RTC_SCENE_FLAG_NONE) {
        rtcSetGeometryUserPrimitiveCount(tree_.geometry, static_cast<unsigned>(sheets.triangles()));
        rtcSetGeometryUserData(tree_.geometry, this);
        rtcSetGeometryBoundsFunction(tree_.geometry, bound, nullptr);
        update();
    }

    void update() override {
        make_boxes(sheets_, x_, boxes_);
        tree_.commit();
    }

    void query() override { rtcCollide(tree_.scene, tree_.scene, collect, this); }

private:
    /// Grown by half of the thickness, and outwards by what single precision may be off.
    static void bound(const RTCBoundsFunctionArguments* arguments) {
        const EmbreePairs& self = *static_cast<EmbreePairs*>(arguments->geometryUserPtr);
        const Aabb& box = self.boxes_[arguments->primID];
        const Real reach = self.sheets_.thickness / 2;
        const auto low = [&](int axis) { return rounded(box.low[axis] - reach, -1); };
        const auto high = [&](int axis) { return rounded(box.high[axis] + reach, 1); };
        RTCBounds& bounds = *arguments->bounds_o;
        bounds.lower_x = low(0), bounds.lower_y = low(1), bounds.lower_z = low(2);
        bounds.upper_x = high(0), bounds.upper_y = high(1), bounds.upper_z = high(2);
    }

    static float rounded(Real value, Real way) {
        return static_cast<float>(value + way * std::abs(value) * Real(std::numeric_limits<float>::epsilon()));
    }

    /// Embree hands on all that two leaves hold, in both orders; the test is the caller's.
    static void collect(void* self, RTCCollision* collisions, unsigned count) {
        EmbreePairs& method = *static_cast<EmbreePairs*>(self);
        for (unsigned k = 0; k < count; ++k) {
            const unsigned a = collisions[k].primID0, b = collisions[k].primID1;
            if (a >= b || !meet(method.boxes_[a], method.boxes_[b], method.sheets_.thickness)) continue;
            method.keep(static_cast<int>(a), static_cast<int>(b));
        }
    }

    MovingScene tree_;
    std::vector<Aabb> boxes_;
};

}  // namespace

void add_embree(Runners& runners, const Motion& motion) {
    const auto add = [&](const std::string& name, Shape shape, RTCBuildQuality quality) {
        runners.push_back(std::make_unique<EmbreeTree>("Embree " + name, motion, shape, quality));
    };
    add("triangles refit", Shape::Triangles, RTC_BUILD_QUALITY_REFIT);
    add("triangles rebuild", Shape::Triangles, RTC_BUILD_QUALITY_LOW);
    add("quads refit", Shape::Quads, RTC_BUILD_QUALITY_REFIT);
    add("quads rebuild", Shape::Quads, RTC_BUILD_QUALITY_LOW);
}

void add_embree(Runners& runners, const Sheets& sheets) {
    runners.push_back(std::make_unique<EmbreePairs>("Embree rtcCollide refit", sheets, RTC_BUILD_QUALITY_REFIT));
    runners.push_back(std::make_unique<EmbreePairs>("Embree rtcCollide rebuild", sheets, RTC_BUILD_QUALITY_LOW));
}

}  // namespace drape::peers
