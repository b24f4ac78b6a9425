#include "drape/bounds/refit_nodes.h"

#include "drape/bounds/cloth_quadtree.h"

namespace drape {

void refit_nodes(const BroadPhaseParameters& parameters, const Grid& grid, const Points& x, std::span<NodeView> nodes) {
    if (parameters.volume == VolumeKind::Brute) return;
    with_volume(parameters.volume, [&]<class Volume>(std::type_identity<Volume>) {
        const auto fit = fits_of<Volume>(parameters).patch;
        for (NodeView& node : nodes) node.volume = fit(patch_of(grid, node.cells, x));
    });
}

}  // namespace drape
