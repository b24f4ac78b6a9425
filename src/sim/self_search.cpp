#include "drape/sim/self_search.h"

#include <algorithm>
#include <limits>

#include "drape/contact/crossings.h"

namespace drape {
namespace {

/// How much farther than the integrator has moved it a response is thought to move a particle.
constexpr Real response_allowance = Real(1.5);

/// For how many substeps like this one a list is to last, by at most a part of the particles' spacing, and how much of
/// the thickness at rest.
constexpr Real substeps_ahead = 4, spacing_ahead = Real(0.2), thickness_ahead = Real(0.25);

/// Pairs of a flat sheet that are within a reach, a particle and a square of the particles' spacing.
constexpr Real pairs_a_square = 30;

/// Pairs of leaves that are looked through from one look at the length of the list to the next.
constexpr std::size_t leaves_at_once = 1024;

/// Within which what touches at distance 0 is looked for [m]: more than the rounding of a scene of some metres.
constexpr Real coincident_reach = std::max(Real(1e-6), 256 * std::numeric_limits<Real>::epsilon());

/// Pairs of leaves of which all pairs at distance 0 are listed at once: where whole cloths are in one place, there are
/// thousands in each.
constexpr std::size_t coincident_leaves_at_once = 64;

/// A cloth at the start of the substep.
ClothAt at(std::span<const ClothInContact> cloths, int number) {
    const ClothInContact& cloth = cloths[static_cast<std::size_t>(number)];
    return {number, cloth.model.grid, cloth.before};
}

/// What all particles move by together from one set of positions to another.
/// @param from, to give the positions of a cloth
template <class From, class To>
Vec3 common_motion(std::size_t cloths, From from, To to) {
    Vec3 sum = Vec3::Zero();
    Eigen::Index particles = 0;
    for (std::size_t c = 0; c < cloths; ++c) {
        sum += (to(c) - from(c)).colwise().sum().transpose();
        particles += to(c).rows();
    }
    return sum / static_cast<Real>(particles);
}

/// Adds how far each particle of a cloth has moved, but for a common motion.
template <class Numbers>
void add_lengths_of_motion(const Points& from, const Points& to, const Vec3& common, Numbers lengths) {
    const auto along = [&](int axis) {
        return (to.col(axis).array() - from.col(axis).array() - common[axis]).square();
    };
    lengths += (along(0) + along(1) + along(2)).sqrt();
}

}  // namespace

void SelfSearch::use(const BroadPhaseParameters& parameters, std::span<const ClothModel* const> models) {
    surfaces_.clear();
    first_.assign(1, 0);
    for (const ClothModel* model : models) {
        surfaces_.push_back({.tree = make_broad_phase(parameters, model->grid),
                             .folds = FoldTest(model->grid, model->hx, model->hy, parameters.leaf_cells),
                             .boxes = {},
                             .kept = {},
                             .grid = model->grid,
                             .spacing = std::min(model->hx, model->hy)});
        first_.push_back(first_.back() + static_cast<std::size_t>(model->grid.particles()));
    }
    const auto all = static_cast<Eigen::Index>(first_.back());
    for (Numbers* numbers : {&ways_, &reaches_, &strayed_, &allowed_}) numbers->setZero(all);
    forget();
}

/// Sums up count(first, second, leaves), over all pairs of cloths, and each with itself.
/// @param reach by which boxes are grown [m]
template <class Count>
std::int64_t SelfSearch::count_between(std::span<const Points* const> x, Real reach, Count count) {
    forget();
    reaches_ = reach;
    std::vector<BoxedCloth> boxed;
    for (std::size_t c = 0; c < x.size(); ++c) {
        Surface& surface = surfaces_[c];
        const std::span<const Real> reaches = of_cloth(reaches_, static_cast<int>(c));
        surface.tree->build(*x[c]);
        surface.boxes.build(surface.grid, *x[c], reaches);
        boxed.push_back({{static_cast<int>(c), surface.grid, *x[c]}, surface.boxes, reaches});
    }
    std::int64_t sum = 0;
    for (std::size_t first = 0; first < x.size(); ++first) {
        for (std::size_t second = first; second < x.size(); ++second) {
            surfaces_[first].tree->query(*surfaces_[second].tree, 2 * reach, nullptr, leaves_);
            sum += count(boxed[first], boxed[second]);
        }
    }
    return sum;
}

std::int64_t SelfSearch::count_crossings(std::span<const Points* const> x) {
    return count_between(x, 0, [&](const BoxedCloth& first, const BoxedCloth& second) {
        return drape::count_crossings(first, second, leaves_);
    });
}

std::int64_t SelfSearch::count_coincident(std::span<const Points* const> x) {
    const std::int64_t count = count_between(x, coincident_reach, [&](const auto& first, const auto& second) {
        const std::span all(leaves_);
        std::int64_t sum = 0;
        for (std::size_t at = 0; at < all.size(); at += coincident_leaves_at_once) {
            near_.clear();
            find_near_pairs(first, second, all.subspan(at, std::min(coincident_leaves_at_once, all.size() - at)),
                            near_);
            sum += std::ranges::count_if(near_,
                                         [](const NearPair& pair) { return pair.stands_alone && pair.distance == 0; });
        }
        return sum;
    });
    near_.clear();
    return count;
}

void SelfSearch::forget() {
    listed_ = false;
    list_.clear();
    near_.clear();
}

std::span<const Real> SelfSearch::of_cloth(const Numbers& of_particles, int cloth) const {
    const auto c = static_cast<std::size_t>(cloth);
    return {of_particles.data() + first_[c], first_[c + 1] - first_[c]};
}

void SelfSearch::find_ways(std::span<const ClothInContact> cloths) {
    const auto before = [&](std::size_t c) -> const Points& { return cloths[c].before; };
    const auto now = [&](std::size_t c) -> const Points& { return cloths[c].state.x; };
    const Vec3 common = common_motion(cloths.size(), before, now);
    ways_.setZero();
    for (std::size_t c = 0; c < cloths.size(); ++c) {
        const auto from = static_cast<Eigen::Index>(first_[c]), count = before(c).rows();
        add_lengths_of_motion(before(c), now(c), common, ways_.segment(from, count));
    }
}

void SelfSearch::find_strayed(std::span<const ClothInContact> cloths) {
    strayed_ = reaches_;
    if (!listed_) return;
    const auto kept = [&](std::size_t c) -> const Points& { return surfaces_[c].kept; };
    const auto before = [&](std::size_t c) -> const Points& { return cloths[c].before; };
    const Vec3 common = common_motion(cloths.size(), kept, before);
    for (std::size_t c = 0; c < cloths.size(); ++c) {
        const auto from = static_cast<Eigen::Index>(first_[c]), count = before(c).rows();
        add_lengths_of_motion(kept(c), before(c), common, strayed_.segment(from, count));
    }
}

/// For a new list: by how much each particle may stray while it serves.
void SelfSearch::set_allowances() {
    for (std::size_t c = 0; c < surfaces_.size(); ++c) {
        const auto from = static_cast<Eigen::Index>(first_[c]), count = static_cast<Eigen::Index>(first_[c + 1]) - from;
        const Real most = spacing_ahead * surfaces_[c].spacing;
        allowed_.segment(from, count) = reaches_.segment(from, count) + thickness_ahead * thickness_ +
                                        (substeps_ahead * ways_.segment(from, count)).min(most);
    }
}

/// Whether so many particles reach so far that a list of all that is near would not fit.
bool SelfSearch::is_too_far() const {
    Real squares = 0;
    for (std::size_t c = 0; c < surfaces_.size(); ++c) {
        for (const Real reach : of_cloth(reaches_, static_cast<int>(c))) {
            const Real spacings = 2 * reach / surfaces_[c].spacing;
            squares += spacings * spacings;
        }
    }
    return !(pairs_a_square * squares <= most_pairs * static_cast<Real>(first_.back()));
}

bool SelfSearch::is_too_long(std::size_t list) const { return list > most_pairs * first_.back(); }

/// Of the particles of both features, the largest numbers together.
Real SelfSearch::sum_of_largest(const FeaturePair& pair, const Numbers& of_particles) const {
    const auto& [cloths, count, p] = pair;
    const Real* const of_first = of_particles.data() + first_[static_cast<std::size_t>(cloths[0])];
    const Real* const of_second = of_particles.data() + first_[static_cast<std::size_t>(cloths[1])];
    const Real of_two = std::max(of_second[p[2]], of_second[p[3]]);
    return count == 1 ? of_first[p[0]] + std::max(of_second[p[1]], of_two)
                      : std::max(of_first[p[0]], of_first[p[1]]) + of_two;
}

Real SelfSearch::reach_of(const FeaturePair& pair) const { return sum_of_largest(pair, reaches_); }

SelfSearchReport SelfSearch::find(std::span<const ClothInContact> cloths, Real thickness) {
    SelfSearchReport report;
    thickness_ = thickness;
    find_ways(cloths);
    reaches_ = thickness / 2 + response_allowance * ways_;
    look_at_pairs(cloths, report);
    return report;
}

bool SelfSearch::extend(std::span<const ClothInContact> cloths, SelfSearchReport& report) {
    find_ways(cloths);
    // Half of the thickness is what features that were not found keep between them
    if ((ways_ + thickness_ / 4 <= reaches_).all()) return false;
    reaches_ = reaches_.max(ways_ + thickness_ / 2);
    look_at_pairs(cloths, report);
    return !report.gave_up;
}

/// A pair that was farther apart than both features have strayed, and may yet reach, is not near.
void SelfSearch::look_at_pairs(std::span<const ClothInContact> cloths, SelfSearchReport& report) {
    report.gave_up = is_too_far();
    if (report.gave_up) return forget();
    find_strayed(cloths);
    if (!listed_ || (strayed_ > allowed_).any()) {
        set_allowances();
        make_list(cloths, report);
        if (report.gave_up) return forget();
        strayed_ = reaches_;
    }
    list_.look_through(near_, [&](const PairList::Listed& listed, std::vector<NearPair>& near) {
        const auto& [features, triangle, distance] = listed;
        if (distance >= sum_of_largest(features, strayed_)) return;
        NearPair pair{features, triangle};
        locate(at(cloths, features.cloths[0]), at(cloths, features.cloths[1]), pair);
        if (pair.distance < reach_of(features)) near.push_back(pair);
    });
    report.listed = static_cast<std::int64_t>(list_.size());
}

void SelfSearch::make_list(std::span<const ClothInContact> cloths, SelfSearchReport& report) {
    for (std::size_t c = 0; c < cloths.size(); ++c) {
        Surface& surface = surfaces_[c];
        surface.kept = cloths[c].before;
        surface.tree->build(surface.kept);
        surface.folds.build(surface.kept, of_cloth(allowed_, static_cast<int>(c)));
        surface.boxed = false;
    }
    list_.clear();
    const int count = static_cast<int>(cloths.size());
    for (int first = 0; first < count; ++first) {
        for (int second = first; second < count; ++second) search(cloths, first, second, report);
    }
    list_.close();
    listed_ = true;
}

/// Boxes are built where anything comes near at all.
void SelfSearch::search(std::span<const ClothInContact> cloths, int first, int second, SelfSearchReport& report) {
    const auto box = [&](int number) {
        Surface& surface = surfaces_[static_cast<std::size_t>(number)];
        const ClothAt cloth = at(cloths, number);
        if (!surface.boxed) surface.boxes.build(cloth.grid, cloth.x, of_cloth(allowed_, number));
        surface.boxed = true;
        return BoxedCloth{cloth, surface.boxes, of_cloth(allowed_, number)};
    };
    const auto largest = [&](int number) { return std::ranges::max(of_cloth(allowed_, number)); };
    const Surface &one = surfaces_[static_cast<std::size_t>(first)], &two = surfaces_[static_cast<std::size_t>(second)];
    const Real margin = largest(first) + largest(second);
    report.traversal += one.tree->query(*two.tree, margin, first == second ? &one.folds : nullptr, leaves_);
    if (leaves_.empty()) return;
    const BoxedCloth at_one = box(first), at_two = box(second);
    for (std::size_t k = 0; k < leaves_.size(); k += leaves_at_once) {
        const auto some = std::span(leaves_).subspan(k, std::min(leaves_at_once, leaves_.size() - k));
        list_.add(at_one, at_two, some);
        report.gave_up = report.gave_up || is_too_long(list_.size());
        if (report.gave_up) return;
    }
}

}  // namespace drape
