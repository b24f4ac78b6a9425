#include "holders.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "frame_data.h"

namespace drape {

namespace {

// In metres, as wide as such things are
constexpr float rod_radius = 0.009f, pole_radius = 0.013f, bar_radius = 0.008f, cord_radius = 0.0035f;
constexpr float jaw_radius = 0.01f, bolt_radius = 0.008f;
constexpr float peg_radius = 0.007f, peg_length = 0.05f, ring_radius = 0.018f, ring_wire = 0.0025f;
constexpr float stands_out = 0.06f;  // of a rod, beyond the row's ends
constexpr float ring_distance = 0.1f;
constexpr float ceiling = 4;  // over the particle, where cords end
constexpr int max_pegs = 16;

const Eigen::Vector3f up = Eigen::Vector3f::UnitY();

struct Hanging {
    const ClothView& cloth;
    const FrameView& view;
    bool upright;  // as it started
    bool moving;   // pins
    std::vector<Holder>& holders;

    [[nodiscard]] Eigen::Vector3f at(int p) const { return drawn_particle(cloth, view.blend, p).cast<float>(); }

    void add_rod(const Eigen::Vector3f& from, const Eigen::Vector3f& to, float radius) const {
        holders.push_back({from, radius, to, 0});
    }

    // The rings hang from the rod, and the particles from the rings
    void add_rod_with_rings(int first, int count, const Eigen::Vector3f& beyond) const {
        const Eigen::Vector3f lift = (2 * ring_radius - ring_wire - rod_radius) * up;
        const Eigen::Vector3f from = at(first) + lift - beyond, to = at(first + count - 1) + lift + beyond;
        add_rod(from, to, rod_radius);
        for (const Eigen::Vector3f& end : {from, to}) add_rod(end, end, 2 * rod_radius);
        const int every = std::max(1, static_cast<int>(ring_distance / static_cast<float>(cloth.model.hx)));
        for (int k = 0; k < count; k += every)
            holders.push_back({at(first + k) + ring_radius * up, ring_wire, beyond.normalized(), ring_radius});
    }

    // Two bars with the cloth between them, bolted at their ends, which face the opposite line's middle
    void add_jaws(const Eigen::Vector3f& from, const Eigen::Vector3f& to, int middle) const {
        const Eigen::Vector3f inwards = at(cloth.model.grid.particles() - 1 - middle) - at(middle);
        const Eigen::Vector3f aside = jaw_radius * (to - from).cross(inwards).normalized();
        add_rod(from + aside, to + aside, jaw_radius);
        add_rod(from - aside, to - aside, jaw_radius);
        for (const Eigen::Vector3f& end : {from, to}) add_rod(end - 2.2f * aside, end + 2.2f * aside, bolt_radius);
    }

    // @return false unless all particles of a row or column are pinned
    [[nodiscard]] bool add_line(int first, int step, int count) const {
        for (int k = 0; k < count; ++k) {
            if (!cloth.model.pinned(first + k * step)) return false;
        }
        const Eigen::Vector3f from = at(first), to = at(first + (count - 1) * step);
        const Eigen::Vector3f beyond = stands_out * (to - from).normalized();
        if (upright && step != 1 && !moving) {
            const Eigen::Vector3f tip = (from.y() > to.y() ? from : to) + stands_out * up;
            add_rod({tip.x(), static_cast<float>(view.settings->ground.height), tip.z()}, tip, pole_radius);
            add_rod(tip, tip, 1.9f * pole_radius);
        } else if (upright && first == 0 && step == 1 && !moving) {
            add_rod_with_rings(first, count, beyond);
        } else if (moving) {
            add_jaws(from - beyond, to + beyond, first + count / 2 * step);
        } else {
            add_rod(from - beyond, to + beyond, bar_radius);
        }
        return true;
    }

    void add_pegs() const {
        int pegs = 0;
        for (int p = 0; p < cloth.model.grid.particles() && pegs < max_pegs; ++p) {
            if (!cloth.model.pinned(p) || p == cloth.grabbed) continue;
            ++pegs;
            const Eigen::Vector3f top = at(p) + 0.7f * peg_length * up;
            add_rod(top - peg_length * up, top, peg_radius);
            add_rod(top, top + ceiling * up, cord_radius);
        }
    }
};

}  // namespace

void hang(const FrameView& view, std::vector<Holder>& holders) {
    holders.clear();
    for (std::size_t number = 0; number < view.cloths.size(); ++number) {
        const ClothView& cloth = view.cloths[number];
        const auto leads = [&](const PinSettings& pins) { return pins.cloth == static_cast<int>(number); };
        const Hanging hanging{cloth, view, view.settings->cloths[number].plane == Plane::XY,
                              std::ranges::any_of(view.settings->pins, leads), holders};
        const Grid& grid = cloth.model.grid;
        bool lines = false;
        for (int j = 0; j < grid.ny; ++j) lines |= hanging.add_line(grid.particle(0, j), 1, grid.nx);
        for (int i = 0; i < grid.nx; ++i) lines |= hanging.add_line(grid.particle(i, 0), grid.nx, grid.ny);
        if (!lines) hanging.add_pegs();
    }
}

}  // namespace drape
