// The positions that `collide` reads: every bounding volume finds the triangles that brute force finds.

#include <algorithm>
#include <sstream>

#include "drape/bounds/broad_phase.h"
#include "drape/contact/detection.h"
#include "fuzz/target.h"
#include "lab/commands.h"

using namespace drape;

namespace {

constexpr Grid grid{3, 3};

std::vector<int> touched(const Points& x, const Ball& ball, VolumeKind volume) {
    BroadPhaseParameters parameters;
    parameters.volume = volume;
    parameters.leaf_cells = 1;
    const auto broad_phase = make_broad_phase(parameters, grid);
    broad_phase->build(x);
    Candidates found;
    broad_phase->query(ball, found);
    std::vector<int> triangles;
    find_touched_triangles(grid, x, ball, 0, found.cells, triangles, Kernels::Vector);
    std::ranges::sort(triangles);
    return triangles;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::istringstream in{std::string(fuzz::text_of(data, size))};
    Points x;
    if (!fuzz::accepts([&] { x = read_positions(in, "fuzz.csv", grid); })) return 0;
    // A ball that comes near: about one particle, with its distance to another or a part of it as the radius
    for (const Real share : {Real(1), Real(0.5), Real(0.01)}) {
        const Vec3 centre = x.row(4).transpose() + Vec3(0, share * Real(0.01), 0);
        const Ball ball{.centre = centre, .radius = share * (x.row(1).transpose() - centre).norm()};
        const std::vector<int> wanted = touched(x, ball, VolumeKind::Brute);
        for (const VolumeKind volume : values_of<VolumeKind>()) {
            fuzz::require(touched(x, ball, volume) == wanted, name_of(volume).c_str());
        }
    }
    return 0;
}
