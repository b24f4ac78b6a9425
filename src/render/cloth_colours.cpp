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

void differences(const ComparisonView* comparison, std::size_t cloth, float* values) {
    if (comparison != nullptr) std::ranges::copy(comparison->distances[cloth], values);
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

}  // namespace

double round_number_above(double value) {
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor * power >= value * (1 - 1e-9)) return factor * power;
    }
    return 10 * power;
}

void ClothColours::collect(const FrameView& view) {
    scale_ = *std::ranges::find(scales, view.settings->view.colour, &ColourScale::by);
    values_.clear();
    if (scale_.by == ColourBy::Plain || scale_.by == ColourBy::Side) return;
    std::size_t particles = 0;
    for (const ClothView& cloth : view.cloths) particles += static_cast<std::size_t>(cloth.model.grid.particles());
    values_.assign(particles, 0);
    scale_.by == ColourBy::Level ? collect_groups(view) : collect_values(view);
}

void ClothColours::collect_values(const FrameView& view) {
    float* values = values_.data();
    std::size_t number = 0;
    for (const ClothView& cloth : view.cloths) {
        if (scale_.by == ColourBy::Difference) differences(view.comparison, number++, values);
        if (scale_.by == ColourBy::Strain || scale_.by == ColourBy::PrincipalStrain) strains(cloth, values);
        if (scale_.by == ColourBy::Speed) speeds(cloth, values);
        if (scale_.by == ColourBy::Depth) depths(cloth, values);
        values += cloth.model.grid.particles();
    }
    const double largest = values_.empty() ? 0 : scale_.units * static_cast<double>(*std::ranges::max_element(values_));
    // A thousandth of a unit and less is rounding; a scale of differences ends at 1 mm or more
    const double least = scale_.by == ColourBy::Difference ? 1 : 1e-3;
    scale_.most = std::isfinite(largest) ? round_number_above(std::max(largest, least)) : 1;
    for (float& value : values_) value *= static_cast<float>(scale_.units / scale_.most);
}

// Nodes lie like the squares of a chessboard: two colours along rows and two along columns keep neighbours apart
void ClothColours::collect_groups(const FrameView& view) {
    const int shown = shown_level(view).level;
    float* values = values_.data();
    for (const ClothView& cloth : view.cloths) {
        const Grid& grid = cloth.model.grid;
        nodes_.clear();
        if (cloth.hierarchy->levels() > 0) {
            cloth.hierarchy->nodes_at(std::min(shown, cloth.hierarchy->levels() - 1), nodes_);
        }
        columns_.assign(static_cast<std::size_t>(grid.nx), 0);
        rows_.assign(static_cast<std::size_t>(grid.ny), 0);
        for (const NodeView& node : nodes_) {
            columns_[static_cast<std::size_t>(node.cells.i0)] = 1;
            rows_[static_cast<std::size_t>(node.cells.j0)] = 1;
        }
        for (const NodeView& node : nodes_) {
            const auto column = std::count(columns_.begin(), columns_.begin() + node.cells.i0, 1);
            const auto row = std::count(rows_.begin(), rows_.begin() + node.cells.j0, 1);
            const auto group = static_cast<float>(column % 2 + 2 * (row % 2));
            for (int j = node.cells.j0; j < node.cells.j1; ++j) {
                for (int i = node.cells.i0; i < node.cells.i1; ++i) values[grid.particle(i + 1, j)] = group;
            }
        }
        values += grid.particles();
    }
}

}  // namespace drape
