#include "cloth_colours.h"

#include <algorithm>
#include <cmath>

#include "drape/model/stencils.h"
#include "drape/session/comparison.h"

namespace drape {

namespace {

// Of each particle, the largest of its structural springs; compressed ones count as nothing
void strains(const ClothView& cloth, float* values) {
    const Grid& grid = cloth.model.grid;
    const Points& x = cloth.x;
    for (std::size_t k = 0; k < 2; ++k) {
        const auto [di, dj] = spring_directions[k];
        const Real rest = k == 0 ? cloth.model.hx : cloth.model.hy;
        SpringStencil{di, dj, {}, 0}.for_each(grid, [&](int a, int b) {
            const auto strain = static_cast<float>((x.row(a) - x.row(b)).norm() / rest - 1);
            for (const int end : {a, b}) values[end] = std::max(values[end], strain);
        });
    }
}

void speeds(const ClothView& cloth, float* values) {
    if (cloth.v == nullptr) return;
    for (int p = 0; p < cloth.model.grid.particles(); ++p) values[p] = static_cast<float>(cloth.v->row(p).norm());
}

void depths(const ClothView& cloth, float* values) {
    for (const ContactRow& row : cloth.contacts) {
        for (const RowParticle& p : row.moved()) {
            if (p.weight <= 0) continue;
            float& value = values[p.particle];
            value = std::max(value, static_cast<float>(row.depth));
        }
    }
}

constexpr std::array<ColourScale, 8> scales{{
    {ColourBy::Plain, 1, "", "", 1},
    {ColourBy::Strain, 1, "Strain", "%", 100},
    {ColourBy::PrincipalStrain, 1, "Strain", "%", 100},
    {ColourBy::Speed, 1, "Speed", "m/s", 1},
    {ColourBy::Depth, 1, "Contact depth", "mm", 1000},
    {ColourBy::Level, 1, "Nodes of level", "", 1},
    {ColourBy::Side, 1, "Side", "", 1},
    {ColourBy::Difference, 1, "Apart", "mm", 1000},
}};

void collect_values(const FrameView& view, ClothColours& colours) {
    auto& [scale, values_of_all] = colours;
    float* values = values_of_all.data();
    std::size_t number = 0;
    for (const ClothView& cloth : view.cloths) {
        if (scale.by == ColourBy::Difference && view.comparison != nullptr) {
            std::ranges::copy(view.comparison->distances[number++], values);
        }
        if (scale.by == ColourBy::Strain || scale.by == ColourBy::PrincipalStrain) strains(cloth, values);
        if (scale.by == ColourBy::Speed) speeds(cloth, values);
        if (scale.by == ColourBy::Depth) depths(cloth, values);
        values += cloth.model.grid.particles();
    }
    const double largest =
        values_of_all.empty() ? 0 : scale.units * static_cast<double>(*std::ranges::max_element(values_of_all));
    // A thousandth of a unit and less is rounding; a scale of differences ends at 1 mm or more
    const double least = scale.by == ColourBy::Difference ? 1 : 1e-3;
    scale.most = std::isfinite(largest) ? round_number_above(std::max(largest, least)) : 1;
    for (float& value : values_of_all) value *= static_cast<float>(scale.units / scale.most);
}

// Nodes lie like the squares of a chessboard: two colours along rows and two along columns keep neighbours apart
void collect_groups(const FrameView& view, float* values) {
    const int shown = shown_level(view).level;
    std::vector<NodeView> nodes;
    std::vector<char> columns, rows;  // 1 where a node of the level starts
    for (const ClothView& cloth : view.cloths) {
        const Grid& grid = cloth.model.grid;
        cloth.hierarchy->nodes_at(shown, nodes);
        columns.assign(static_cast<std::size_t>(grid.nx), 0);
        rows.assign(static_cast<std::size_t>(grid.ny), 0);
        for (const NodeView& node : nodes) {
            columns[static_cast<std::size_t>(node.cells.i0)] = 1;
            rows[static_cast<std::size_t>(node.cells.j0)] = 1;
        }
        for (const NodeView& node : nodes) {
            const auto column = std::count(columns.begin(), columns.begin() + node.cells.i0, 1);
            const auto row = std::count(rows.begin(), rows.begin() + node.cells.j0, 1);
            const auto group = static_cast<float>(column % 2 + 2 * (row % 2));
            for (int j = node.cells.j0; j < node.cells.j1; ++j) {
                for (int i = node.cells.i0; i < node.cells.i1; ++i) values[grid.particle(i + 1, j)] = group;
            }
        }
        values += grid.particles();
    }
}

}  // namespace

double round_number_above(double value) {
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor * power >= value * (1 - 1e-9)) return factor * power;
    }
    return 10 * power;
}

ClothColours cloth_colours(const FrameView& view) {
    ClothColours colours{*std::ranges::find(scales, view.settings->view.colour, &ColourScale::by), {}};
    const ColourBy by = colours.scale.by;
    if (by == ColourBy::Plain || by == ColourBy::Side) return colours;
    std::size_t particles = 0;
    for (const ClothView& cloth : view.cloths) particles += static_cast<std::size_t>(cloth.model.grid.particles());
    colours.values.assign(particles, 0);
    by == ColourBy::Level ? collect_groups(view, colours.values.data()) : collect_values(view, colours);
    return colours;
}

}  // namespace drape
