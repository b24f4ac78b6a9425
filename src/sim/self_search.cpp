#include "drape/sim/self_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace drape {
namespace {

/// How much farther than the integrator has moved it a response is thought to move a particle.
constexpr Real response_allowance = Real(1.5);

/// A list has margins for so many substeps like this one: for the most if it is short, and for fewer, down to the
/// least, the longer it is, because most of what makes it long can come near only in the last of them.
constexpr Real max_ahead = 12, min_ahead = 3;

/// With this many pairs a particle, margins are for half of `max_ahead`. It lies between those of `fold` of 64 x 64
/// particles in steps of 0.1 ms, where 6 to 12 substeps cost the same, and in steps of 0.5 ms, where 3 to 4 are best;
/// measured with margins of up to 0.4 spacings.
constexpr Real pairs_of_half = 8;

/// A margin for displacement is at most so many of the particles' spacings: each particle has neighbours at about the
/// spacing, which a wide margin would list.
constexpr Real max_spacings = Real(0.15);

/// How much of the thickness besides, for what is at rest.
constexpr Real thickness_ahead = Real(0.3);

/// Pairs of a flat sheet that are within a reach, a particle and a square of the particles' spacing.
constexpr Real pairs_a_square = 30;

/// Pairs of leaves that are looked through from one look at the length of the list to the next.
constexpr std::size_t leaves_at_once = 1024;

/// Within which what touches at distance 0 is looked for [m]: more than the rounding of a scene of some metres.
constexpr Real coincident_reach = std::max(Real(1e-6), 256 * std::numeric_limits<Real>::epsilon());

/// Pairs of leaves of which all pairs at distance 0 are listed at once: where whole cloths are in one place, there are
/// thousands in each.
constexpr std::size_t coincident_leaves_at_once = 64;

/// The side of a leaf where none is given: a pair of leaves is tested cell by cell.
constexpr int pair_leaf_cells = 4;

/// Of the thickness, that cloth keeps from cloth whatever presses it.
constexpr Real of_thickness_kept = Real(1e-3);

/// A cloth at the start of the substep.
ClothAt at(std::span<const ClothInContact> cloths, int number) {
    const ClothInContact& cloth = cloths[static_cast<std::size_t>(number)];
    return {number, cloth.model.grid, cloth.before};
}

/// The sums of the columns, in the order of the rows.
Vec3 sum_of(const Points& x) {
    Vec3 sum = Vec3::Zero();
    for (Eigen::Index p = 0; p < x.rows(); ++p) sum += x.row(p).transpose();
    return sum;
}

/// By how much each particle moves, but for a mean.
auto own_motion(const Points& from, const Points& to, const Vec3& mean) {
    const auto square = [&](int axis) { return (to.col(axis).array() - from.col(axis).array() - mean[axis]).square(); };
    return ((square(0) + square(1)) + square(2)).sqrt();
}

}  // namespace

void SelfSearch::use(const Settings& settings, std::span<const ClothInContact> cloths) {
    *this = {};
    on_ = settings.contact.self;
    if (!on_) return;
    use_threads(settings.solver.threads);
    use(broad_phase_of(settings), cloths);
    crossings_at_start_ = count_between(
        cloths, 0, [&](const auto& first, const auto& second) { return count_crossings(first, second, leaves_); });
    coincident_at_start_ = count_coincident(cloths);
}

void SelfSearch::use(BroadPhaseParameters parameters, std::span<const ClothInContact> cloths) {
    parameters.search = {};
    if (parameters.leaf_cells == 0) parameters.leaf_cells = pair_leaf_cells;
    surfaces_.clear();
    first_.assign(1, 0);
    for (const ClothInContact& cloth : cloths) {
        const ClothModel& model = cloth.model;
        surfaces_.push_back({.tree = make_broad_phase(parameters, model.grid),
                             .folds = FoldTest(model.grid, model.hx, model.hy, parameters.leaf_cells),
                             .spacing = std::min(model.hx, model.hy)});
        first_.push_back(first_.back() + static_cast<std::size_t>(model.grid.particles()));
    }
    const auto all = static_cast<Eigen::Index>(first_.back());
    for (Numbers* numbers : {&reaches_, &displacement_since_list_, &allowance_, &more_reaches_, &more_strayed_})
        numbers->setZero(all);
    forget();
}

/// Sums up count(first, second), with the leaves in `leaves_`, over all pairs of cloths, and each with itself.
/// @param reach by which boxes are grown [m]
template <class Count>
std::int64_t SelfSearch::count_between(std::span<const ClothInContact> cloths, Real reach, Count count) {
    forget();
    reaches_ = reach;
    for (std::size_t c = 0; c < cloths.size(); ++c) {
        surfaces_[c].tree->build(cloths[c].before);
        surfaces_[c].boxed = false;
    }
    std::int64_t sum = 0;
    for (std::size_t first = 0; first < cloths.size(); ++first) {
        for (std::size_t second = first; second < cloths.size(); ++second) {
            surfaces_[first].tree->query(*surfaces_[second].tree, 2 * reach, nullptr, leaves_);
            sum += count(boxed(cloths, first, reaches_), boxed(cloths, second, reaches_));
        }
    }
    return sum;
}

/// Boxes are built when they are first asked for.
BoxedCloth SelfSearch::boxed(std::span<const ClothInContact> cloths, std::size_t number, const Numbers& reaches) {
    Surface& surface = surfaces_[number];
    const ClothAt cloth = at(cloths, static_cast<int>(number));
    const std::span<const Real> own = of_cloth(reaches, cloth.number);
    if (!surface.boxed) surface.boxes.build(cloth.grid, cloth.x, own);
    surface.boxed = true;
    return {cloth, surface.boxes, own};
}

std::int64_t SelfSearch::count_coincident(std::span<const ClothInContact> cloths) {
    const std::int64_t count = count_between(cloths, coincident_reach, [&](const auto& first, const auto& second) {
        const std::span all(leaves_);
        std::int64_t sum = 0;
        for (std::size_t at = 0; at < all.size(); at += coincident_leaves_at_once) {
            near_.clear();
            find_near_pairs(first, second, all.subspan(at, std::min(coincident_leaves_at_once, all.size() - at)),
                            near_);
            sum += std::ranges::count_if(
                near_, [](const NearPair& pair) { return pair.is_representative && pair.distance == 0; });
        }
        return sum;
    });
    near_.clear();
    return count;
}

void SelfSearch::forget() {
    ahead_ = max_ahead;
    listed_ = false;
    list_.clear();
    near_.clear();
}

std::span<const Real> SelfSearch::of_cloth(const Numbers& of_particles, int cloth) const {
    const auto c = static_cast<std::size_t>(cloth);
    return {of_particles.data() + first_[c], first_[c + 1] - first_[c]};
}

void SelfSearch::find_mean_motion(std::span<const ClothInContact> cloths) {
    Vec3 before = Vec3::Zero(), now = Vec3::Zero();
    for (const ClothInContact& cloth : cloths) before += sum_of(cloth.before), now += sum_of(cloth.state.x);
    mean_ = before / static_cast<Real>(first_.back());
    moved_ = now / static_cast<Real>(first_.back()) - mean_;
}

/// Without a list nothing has moved since it was made.
/// @param factor of each displacement in its reach
void SelfSearch::find_reaches(std::span<const ClothInContact> cloths, Real factor, Numbers& reaches, Numbers& strayed) {
    for (std::size_t c = 0; c < cloths.size(); ++c) {
        const auto from = static_cast<Eigen::Index>(first_[c]), count = static_cast<Eigen::Index>(first_[c + 1]) - from;
        const ClothInContact& cloth = cloths[c];
        auto reach = reaches.segment(from, count), stray = strayed.segment(from, count);
        reach = thickness_ / 2 + factor * own_motion(cloth.before, cloth.state.x, moved_);
        stray = reach;
        if (listed_) stray += own_motion(surfaces_[c].kept, cloth.before, mean_ - kept_mean_);
    }
}

/// For how many substeps the next list has margins: the geometric mean of the last number and the one that the length
/// of the last list asks for. It goes no further at once, because that length itself depends on the margins.
Real SelfSearch::next_ahead() const {
    const Real pairs = static_cast<Real>(list_.size()) / static_cast<Real>(first_.back());
    return std::sqrt(ahead_ * std::max(min_ahead, max_ahead / (1 + pairs / pairs_of_half)));
}

/// For a new list: by how much each particle may stray while it serves.
/// @param factor of each displacement in its reach
void SelfSearch::set_allowances(Real factor) {
    for (std::size_t c = 0; c < surfaces_.size(); ++c) {
        const auto from = static_cast<Eigen::Index>(first_[c]), count = static_cast<Eigen::Index>(first_[c + 1]) - from;
        const Real most = max_spacings * surfaces_[c].spacing;
        const auto reaches = reaches_.segment(from, count);
        const auto moved = (reaches - thickness_ / 2) / factor;
        allowance_.segment(from, count) = reaches + thickness_ahead * thickness_ + (ahead_ * moved).min(most);
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
    return !(pairs_a_square * squares <= max_pairs * static_cast<Real>(first_.back()));
}

/// Of the particles of both features, the largest numbers together.
Real SelfSearch::sum_of_largest(const FeaturePair& pair, const Numbers& of_particles) const {
    const auto& [cloths, count, p] = pair;
    const Real* const of_first = of_particles.data() + first_[static_cast<std::size_t>(cloths[0])];
    const Real* const of_second = of_particles.data() + first_[static_cast<std::size_t>(cloths[1])];
    const Real of_two = std::max(of_second[p[2]], of_second[p[3]]);
    return count == 1 ? of_first[p[0]] + std::max(of_second[p[1]], of_two)
                      : std::max(of_first[p[0]], of_first[p[1]]) + of_two;
}

Real SelfSearch::reach_of(const NearPair& pair) const { return sum_of_largest(pair.features, reaches_); }

const SelfSearchReport& SelfSearch::find(std::span<const ClothInContact> cloths, Real thickness) {
    report_ = {};
    thickness_ = thickness;
    find_mean_motion(cloths);
    find_reaches(cloths, response_allowance, reaches_, displacement_since_list_);
    if (!listed_ || !(displacement_since_list_ <= allowance_).all()) renew_list(cloths, response_allowance);
    if (!report_.gave_up) look_at_pairs(cloths);
    return report_;
}

void SelfSearch::find_contacts(const ResponseParameters& parameters, std::span<const ClothInContact> cloths,
                               std::vector<ContactRow>& rows) {
    if (!on_) return;
    find(cloths, parameters.pair_thickness);
    for (const NearPair& pair : near_) {
        if (!pair.is_representative || pair.distance == 0) continue;
        ContactRow row = row_of(pair, thickness_);
        update_depths(cloths, {}, {&row, 1});
        // A pair that stays well apart is left to the fail-safe
        if (-row.depth <= (reach_of(pair) - thickness_) / 4) rows.push_back(row);
    }
}

bool SelfSearch::extend(std::span<const ClothInContact> cloths) {
    // Half of the thickness is what features that were not found keep between them
    find_reaches(cloths, 1, more_reaches_, more_strayed_);
    if ((more_reaches_ - thickness_ / 4 <= reaches_).all()) return false;
    reaches_ = reaches_.max(more_reaches_);
    displacement_since_list_ = displacement_since_list_.max(more_strayed_);
    if (!listed_ || !(more_strayed_ <= allowance_).all()) renew_list(cloths, 1);
    if (!report_.gave_up) look_at_pairs(cloths);
    return !report_.gave_up;
}

bool SelfSearch::would_cross(std::span<const ClothInContact> cloths, bool responded) {
    if (!on_) return false;
    if (responded) extend(cloths);
    const Real rounding = 64 * std::numeric_limits<Real>::epsilon();
    return !near_.empty() && zones_.find(near_, cloths, first_, std::max(of_thickness_kept * thickness_, rounding));
}

/// What is held back may move otherwise than the search has assumed.
std::int64_t SelfSearch::prevent_crossing(std::span<const ClothInContact> cloths) {
    do zones_.prevent_crossing(near_);
    while (extend(cloths));
    return zones_.particles();
}

void SelfSearch::renew_list(std::span<const ClothInContact> cloths, Real factor) {
    const auto make = [&](Real ahead) {
        ahead_ = ahead;
        set_allowances(factor);
        report_.gave_up = false;
        make_list(cloths);
    };
    report_.gave_up = is_too_far();
    if (!report_.gave_up) {
        make(next_ahead());
        if (report_.gave_up) make(min_ahead);
    }
    if (report_.gave_up) return forget();
    displacement_since_list_ = reaches_;
}

/// A pair that was farther apart than both features have strayed, and may yet reach, is not near.
void SelfSearch::look_at_pairs(std::span<const ClothInContact> cloths) {
    list_.look_through(near_, [&](const PairList::Listed& listed, std::vector<NearPair>& near) {
        const auto& [features, triangle, distance] = listed;
        if (distance >= sum_of_largest(features, displacement_since_list_)) return;
        NearPair pair{.features = features, .triangle = triangle};
        locate(at(cloths, features.cloths[0]), at(cloths, features.cloths[1]), pair);
        if (pair.distance < reach_of(pair)) near.push_back(pair);
    });
    report_.listed = static_cast<std::int64_t>(list_.size());
}

void SelfSearch::make_list(std::span<const ClothInContact> cloths) {
    for (std::size_t c = 0; c < cloths.size(); ++c) {
        Surface& surface = surfaces_[c];
        surface.kept = cloths[c].before;
        surface.tree->build(surface.kept);
        surface.folds.build(surface.kept, allowances(static_cast<int>(c)));
        surface.boxed = false;
    }
    kept_mean_ = mean_;
    list_.clear();
    for (std::size_t first = 0; first < cloths.size(); ++first) {
        for (std::size_t second = first; second < cloths.size(); ++second) search(cloths, first, second);
    }
    list_.close();
    listed_ = true;
}

void SelfSearch::search(std::span<const ClothInContact> cloths, std::size_t first, std::size_t second) {
    const auto largest = [&](std::size_t number) { return std::ranges::max(allowances(static_cast<int>(number))); };
    const Surface &one = surfaces_[first], &two = surfaces_[second];
    const Real margin = largest(first) + largest(second);
    report_.traversal += one.tree->query(*two.tree, margin, first == second ? &one.folds : nullptr, leaves_);
    if (leaves_.empty()) return;
    const BoxedCloth at_one = boxed(cloths, first, allowance_), at_two = boxed(cloths, second, allowance_);
    const std::span<const LeafPair> leaves(leaves_);
    for (std::size_t k = 0; k < leaves.size() && !report_.gave_up; k += leaves_at_once) {
        list_.add(at_one, at_two, leaves.subspan(k, std::min(leaves_at_once, leaves.size() - k)));
        report_.gave_up = list_.size() > max_pairs * first_.back();
    }
}

}  // namespace drape
