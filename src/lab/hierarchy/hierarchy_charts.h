#pragma once

#include <array>

#include "hierarchy_row.h"
#include "lab/experiment/chart_text.h"

namespace drape {

// The charts of the hierarchy's experiment, each of the rows of one part.

/// Time against accuracy: a panel a scene, a line a volume and update, a point a leaf size.
/// @param resampled of the cloths with more particles than their scenes have
Chart fit_chart(const ChartTable& table, const std::vector<HierarchyRow>& rows, bool resampled);

/// What the fits of spheres cost and how tight they are.
Chart sphere_chart(const ChartTable& table, const std::vector<HierarchyRow>& rows);

/// Tightness, nodes visited, false candidates and time by level of the tree.
Chart level_chart(const ChartTable& table, const std::string& scene);

/// What a search loses that ends early.
Chart budget_chart(const ChartTable& table, const std::vector<HierarchyRow>& rows);

/// What the updates have cost in all, frame by frame and by the time between frames.
Chart break_even_chart(const ChartTable& table, const std::vector<HierarchyRow>& rows, const std::string& scene);

/// Cost against the number of particles, with fitted exponents.
Chart size_chart(const ChartTable& table, const std::vector<HierarchyRow>& rows);

/// The scenes of some rows, each once, in their order.
std::vector<std::string> scenes_of(const std::vector<HierarchyRow>& rows);

/// How a volume is drawn, in one of Okabe and Ito's colours.
struct VolumeStyle {
    const char* volume;
    const char* fit;  ///< of spheres: the original's
    const char* colour;
};
inline constexpr std::array<VolumeStyle, 4> volume_styles{{{"sphere", "centroid", "#0072B2"},
                                                           {"aabb", "none", "#D55E00"},
                                                           {"kdop18", "none", "#009E73"},
                                                           {"obb", "none", "#CC79A7"}}};

/// How an update is drawn: gnuplot's number of the marker, and a colour where volumes need none.
struct UpdateStyle {
    const char* update;
    int marker;
    const char* colour;
};
inline constexpr std::array<UpdateStyle, 4> update_styles{
    {{"rebuild", 7, "#000000"}, {"merge", 5, "#0072B2"}, {"refit", 9, "#D55E00"}, {"none", 13, "#009E73"}}};

}  // namespace drape
