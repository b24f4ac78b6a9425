#include "drape/sim/self_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "drape/contact/crossings.h"

namespace drape {
namespace {

/// How much farther than the integrator has moved it a response is thought to move a particle.
constexpr Real response_allowance = Real(1.5);

/// A list has margins for so many substeps like this one: for the most if it is short, and for fewer, down to the
/// least, the longer it is, because most of what makes it long can come near only in the last of them.
constexpr Real most_ahead = 12, least_ahead = 3;

/// With this many pairs a particle, margins are for half of `most_ahead`. It lies between those of `fold` of 64 x 64
/// particles in steps of 0.1 ms, where 6 to 12 substeps cost the same, and in steps of 0.5 ms, where 3 to 4 are best.
constexpr Real pairs_of_half = 8;

/// A margin for displacement is at most so many of the particles' spacings: what is local has neighbours at about the
/// spacing, which a wide margin would list; of all else, little is near.
constexpr Real local_spacings = Real(0.4), overall_spacings = 1;

/// How much of the thickness besides, for what is at rest.
constexpr Real thickness_ahead = Real(0.1);

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

}  // namespace

void SelfSearch::use(const BroadPhaseParameters& parameters, std::span<const ClothModel* const> models) {
    surfaces_.clear();
    first_.assign(1, 0);
    for (const ClothModel* model : models) {
        const Tiles tiles(model->grid);
        const auto count = static_cast<std::size_t>(tiles.count());
        surfaces_.push_back({.tree = make_broad_phase(parameters, model->grid),
                             .folds = FoldTest(model->grid, model->hx, model->hy, parameters.leaf_cells),
                             .boxes = {},
                             .kept = {},
                             .spacing = std::min(model->hx, model->hy),
                             .tiles = tiles,
                             .sums = std::vector<TileSums>(count),
                             .kept_means = std::vector<Vec3>(count, Vec3::Zero()),
                             .since_kept = std::vector<TileMotion>(count),
                             .within = std::vector<TileMotion>(count)});
        first_.push_back(first_.back() + static_cast<std::size_t>(model->grid.particles()));
    }
    const auto all = static_cast<Eigen::Index>(first_.back());
    for (Reaches* reaches : {&reaches_, &strayed_, &allowed_, &more_reaches_, &more_strayed_}) {
        reaches->local.setZero(all);
        reaches->overall.setZero(all);
    }
    kernels_ = parameters.kernels;
    forget();
}

/// Sums up count(first, second, leaves), over all pairs of cloths, and each with itself.
/// @param reach by which boxes are grown [m]
template <class Count>
std::int64_t SelfSearch::count_between(std::span<const Points* const> x, Real reach, Count count) {
    forget();
    reaches_.overall = reach;
    std::vector<BoxedCloth> boxed;
    for (std::size_t c = 0; c < x.size(); ++c) {
        Surface& surface = surfaces_[c];
        const std::span<const Real> reaches = of_cloth(reaches_, static_cast<int>(c)).overall;
        surface.tree->build(*x[c]);
        surface.boxes.build(surface.tiles.grid, *x[c], reaches);
        boxed.push_back({{static_cast<int>(c), surface.tiles.grid, *x[c]}, surface.boxes, reaches});
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
    ahead_ = most_ahead;
    listed_ = false;
    list_.clear();
    near_.clear();
}

ReachSpans<const Real> SelfSearch::of_cloth(const Reaches& of_particles, int cloth) const {
    const auto c = static_cast<std::size_t>(cloth);
    const std::size_t from = first_[c], count = first_[c + 1] - from;
    return {{of_particles.local.data() + from, count}, {of_particles.overall.data() + from, count}};
}

ReachSpans<Real> SelfSearch::of_cloth(Reaches& of_particles, int cloth) const {
    const auto c = static_cast<std::size_t>(cloth);
    const std::size_t from = first_[c], count = first_[c + 1] - from;
    return {{of_particles.local.data() + from, count}, {of_particles.overall.data() + from, count}};
}

/// Within the substep, and since the list was made: without a list nothing has moved since.
void SelfSearch::find_tile_motion(std::span<const ClothInContact> cloths) {
    Vec3 moved = Vec3::Zero(), moved_since = Vec3::Zero();
    for (std::size_t c = 0; c < surfaces_.size(); ++c) {
        Surface& of = surfaces_[c];
        sum_tiles(of.tiles, cloths[c].before, cloths[c].state.x, of.sums, kernels_);
        for (std::size_t t = 0; t < of.sums.size(); ++t) {
            const Real particles = static_cast<Real>(of.tiles.particles(static_cast<int>(t)).particles());
            of.within[t].mean = of.sums[t].moved / particles;
            of.since_kept[t].mean = listed_ ? Vec3(of.sums[t].before / particles - of.kept_means[t]) : Vec3::Zero();
            moved += of.sums[t].moved;
            moved_since += particles * of.since_kept[t].mean;
        }
    }
    const auto all = static_cast<Real>(first_.back());
    for (Surface& of : surfaces_) {
        compare_tiles(of.tiles, moved / all, of.within);
        compare_tiles(of.tiles, moved_since / all, of.since_kept);
    }
}

ParticleMotion SelfSearch::motion_of(std::span<const ClothInContact> cloths, std::size_t cloth) const {
    const ClothInContact& now = cloths[cloth];
    const Surface& of = surfaces_[cloth];
    return {of.tiles, listed_ ? of.kept : now.before, now.before, now.state.x, of.since_kept, of.within};
}

/// @return whether nothing has strayed farther than the list allows
bool SelfSearch::find_reaches(std::span<const ClothInContact> cloths, Real least, Real factor, Reaches& reaches,
                              Reaches& strayed) {
    bool all_within = true;
    for (std::size_t c = 0; c < cloths.size(); ++c) {
        const int cloth = static_cast<int>(c);
        const bool within =
            drape::find_reaches(motion_of(cloths, c), least, factor, of_cloth(std::as_const(allowed_), cloth),
                                of_cloth(reaches, cloth), of_cloth(strayed, cloth), kernels_);
        all_within = all_within && within;
    }
    return all_within;
}

/// For how many substeps the next list has margins: the geometric mean of the last number and the one that the length
/// of the last list asks for. It goes no further at once, because that length itself depends on the margins.
Real SelfSearch::next_ahead() const {
    const Real pairs = static_cast<Real>(list_.size()) / static_cast<Real>(first_.back());
    return std::sqrt(ahead_ * std::max(least_ahead, most_ahead / (1 + pairs / pairs_of_half)));
}

/// For a new list: by how much each particle may stray while it serves.
/// @param factor of each displacement in its reach
void SelfSearch::set_allowances(Real factor) {
    for (std::size_t c = 0; c < surfaces_.size(); ++c) {
        const auto from = static_cast<Eigen::Index>(first_[c]), count = static_cast<Eigen::Index>(first_[c + 1]) - from;
        const auto set = [&](const Numbers& reaches_of_all, Real spacings, Numbers& allowed) {
            const Real most = spacings * surfaces_[c].spacing;
            const auto reaches = reaches_of_all.segment(from, count);
            const auto moved = (reaches - thickness_ / 2) / factor;
            allowed.segment(from, count) = reaches + thickness_ahead * thickness_ + (ahead_ * moved).min(most);
        };
        set(reaches_.local, local_spacings, allowed_.local);
        set(reaches_.overall, overall_spacings, allowed_.overall);
    }
}

/// Whether so many particles reach so far that a list of all that is near would not fit.
bool SelfSearch::is_too_far() const {
    Real squares = 0;
    for (std::size_t c = 0; c < surfaces_.size(); ++c) {
        for (const Real reach : of_cloth(reaches_, static_cast<int>(c)).overall) {
            const Real spacings = 2 * reach / surfaces_[c].spacing;
            squares += spacings * spacings;
        }
    }
    return !(pairs_a_square * squares <= most_pairs * static_cast<Real>(first_.back()));
}

bool SelfSearch::is_too_long(std::size_t list) const { return list > most_pairs * first_.back(); }

/// Of the particles of both features, the largest numbers together.
Real SelfSearch::sum_of_largest(const FeaturePair& pair, bool local, const Reaches& of_particles) const {
    const auto& [cloths, count, p] = pair;
    const Numbers& numbers = local ? of_particles.local : of_particles.overall;
    const Real* const of_first = numbers.data() + first_[static_cast<std::size_t>(cloths[0])];
    const Real* const of_second = numbers.data() + first_[static_cast<std::size_t>(cloths[1])];
    const Real of_two = std::max(of_second[p[2]], of_second[p[3]]);
    return count == 1 ? of_first[p[0]] + std::max(of_second[p[1]], of_two)
                      : std::max(of_first[p[0]], of_first[p[1]]) + of_two;
}

Real SelfSearch::reach_of(const NearPair& pair) const { return sum_of_largest(pair.features, pair.local, reaches_); }

SelfSearchReport SelfSearch::find(std::span<const ClothInContact> cloths, Real thickness) {
    SelfSearchReport report;
    thickness_ = thickness;
    find_tile_motion(cloths);
    const bool none_strays = find_reaches(cloths, thickness / 2, response_allowance, reaches_, strayed_);
    if (!listed_ || !none_strays) renew_list(cloths, response_allowance, report);
    if (!report.gave_up) look_at_pairs(cloths, report);
    return report;
}

bool SelfSearch::extend(std::span<const ClothInContact> cloths, SelfSearchReport& report) {
    // Half of the thickness is what features that were not found keep between them
    const auto is_within = [&](std::size_t c) {
        return are_within(motion_of(cloths, c), thickness_ / 4,
                          of_cloth(std::as_const(reaches_), static_cast<int>(c)).local, kernels_);
    };
    bool ways_are_within = true;
    for (std::size_t c = 0; c < cloths.size() && ways_are_within; ++c) ways_are_within = is_within(c);
    if (ways_are_within) return false;
    const bool none_strays = find_reaches(cloths, thickness_ / 2, 1, more_reaches_, more_strayed_);
    for (const auto& [reaches, more] : {std::pair(&reaches_, &more_reaches_), {&strayed_, &more_strayed_}}) {
        reaches->local = reaches->local.max(more->local);
        reaches->overall = reaches->overall.max(more->overall);
    }
    if (!listed_ || !none_strays) renew_list(cloths, 1, report);
    if (!report.gave_up) look_at_pairs(cloths, report);
    return !report.gave_up;
}

void SelfSearch::renew_list(std::span<const ClothInContact> cloths, Real factor, SelfSearchReport& report) {
    const auto make = [&](Real ahead) {
        ahead_ = ahead;
        set_allowances(factor);
        report.gave_up = false;
        make_list(cloths, report);
    };
    report.gave_up = is_too_far();
    if (!report.gave_up) {
        make(next_ahead());
        if (report.gave_up) make(least_ahead);
    }
    if (report.gave_up) return forget();
    strayed_ = reaches_;
}

/// A pair that was farther apart than both features have strayed, and may yet reach, is not near.
void SelfSearch::look_at_pairs(std::span<const ClothInContact> cloths, SelfSearchReport& report) {
    list_.look_through(near_, [&](const PairList::Listed& listed, std::vector<NearPair>& near) {
        const auto& [features, triangle, local, distance] = listed;
        if (distance >= sum_of_largest(features, local, strayed_)) return;
        NearPair pair{.features = features, .triangle = triangle, .local = local};
        locate(at(cloths, features.cloths[0]), at(cloths, features.cloths[1]), pair);
        if (pair.distance < reach_of(pair)) near.push_back(pair);
    });
    report.listed = static_cast<std::int64_t>(list_.size());
}

void SelfSearch::make_list(std::span<const ClothInContact> cloths, SelfSearchReport& report) {
    for (std::size_t c = 0; c < cloths.size(); ++c) {
        Surface& surface = surfaces_[c];
        surface.kept = cloths[c].before;
        surface.tree->build(surface.kept);
        const ReachSpans<const Real> allowed = allowances(static_cast<int>(c));
        surface.folds.build(surface.kept, allowed.overall, allowed.local);
        surface.boxed = false;
        std::ranges::fill(surface.since_kept, TileMotion{});
        for (std::size_t t = 0; t < surface.sums.size(); ++t) {
            const int particles = surface.tiles.particles(static_cast<int>(t)).particles();
            surface.kept_means[t] = surface.sums[t].before / static_cast<Real>(particles);
        }
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
        const auto [local, overall] = allowances(number);
        if (!surface.boxed) surface.boxes.build(cloth.grid, cloth.x, overall, local);
        surface.boxed = true;
        return BoxedCloth{cloth, surface.boxes, overall, local};
    };
    const auto largest = [&](int number) { return std::ranges::max(allowances(number).overall); };
    const Surface &one = surfaces_[static_cast<std::size_t>(first)], &two = surfaces_[static_cast<std::size_t>(second)];
    const Real margin = largest(first) + largest(second);
    report.traversal += one.tree->query(*two.tree, margin, first == second ? &one.folds : nullptr, leaves_);
    if (leaves_.empty()) return;
    const BoxedCloth at_one = box(first), at_two = box(second);
    const std::span<const LeafPair> leaves(leaves_);
    for (std::size_t k = 0; k < leaves.size() && !report.gave_up; k += leaves_at_once) {
        list_.add(at_one, at_two, leaves.subspan(k, std::min(leaves_at_once, leaves.size() - k)));
        report.gave_up = is_too_long(list_.size());
    }
}

}  // namespace drape
