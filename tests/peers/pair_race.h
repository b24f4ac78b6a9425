#pragma once

#include <array>
#include <string>
#include <vector>

#include "drape/bounds/aabb.h"
#include "drape/model/grid.h"
#include "runner.h"

namespace drape::peers {

/// Two triangles by their numbers among those of all cloths, the smaller first.
struct TrianglePair {
    int first = 0, second = 0;
    auto operator<=>(const TrianglePair&) const = default;
};

/// The cloths at one time.
struct SheetFrame {
    std::vector<Points> of_cloths;    ///< n x 3 of each [m]
    Points x;                         ///< the same, one after the other
    std::vector<TrianglePair> boxes;  ///< whose boxes are no farther apart than the thickness, ascending
    std::vector<TrianglePair> near;   ///< those of them that are themselves no farther apart, ascending
};

/// The cloths of a scene that meet themselves and each other, frame by frame.
struct Sheets {
    std::string scene;
    int side = 0;  ///< particles
    Real thickness = 0;
    std::vector<Grid> grids;
    std::vector<std::array<Real, 2>> spacings;  ///< hx, hy of each [m]
    std::vector<int> first_triangles;           ///< of each cloth among those of all
    std::vector<std::array<int, 3>> corners;    ///< of each triangle, by the rows of `SheetFrame::x`
    std::vector<SheetFrame> frames;

    /// Simulates a scene, 60 frames a second from half a second after its start. Grids finer than 64 x 64 have the
    /// surface of that one.
    Sheets(const std::string& scene, int side, int count);

    [[nodiscard]] int triangles() const { return static_cast<int>(corners.size()); }
    [[nodiscard]] bool share_particle(int first, int second) const {
        const auto &a = corners[static_cast<std::size_t>(first)], &b = corners[static_cast<std::size_t>(second)];
        for (const int p : a) {
            if (p == b[0] || p == b[1] || p == b[2]) return true;
        }
        return false;
    }
};

/// The boxes of all triangles.
void make_boxes(const Sheets& sheets, const Points& x, std::vector<Aabb>& boxes);

/// Whether boxes that are each grown by half of the thickness overlap: what all methods must find.
inline bool meet(const Aabb& a, const Aabb& b, Real thickness) {
    for (int axis = 0; axis < 3; ++axis) {
        if (a.low[axis] - b.high[axis] > thickness || b.low[axis] - a.high[axis] > thickness) return false;
    }
    return true;
}

/// A pair of triangles in either order.
inline TrianglePair in_order(int a, int b) { return a < b ? TrianglePair{a, b} : TrianglePair{b, a}; }

/// What a method must find.
enum class Sought {
    Boxes,  ///< every pair of triangles whose grown boxes overlap
    Near    ///< of these, at least those that are no farther apart than the thickness: what narrower volumes leave
};

/// A way to find the pairs of triangles of cloths that may touch themselves and each other.
class PairMethod : public Runner {
public:
    /// For what finds pairs: keeps one, unless its triangles share a particle.
    void keep(int first, int second) {
        if (!sheets_.share_particle(first, second)) found_.push_back(in_order(first, second));
    }

protected:
    /// @param sheets outlive the method, which starts at their last frame
    PairMethod(std::string name, const Sheets& sheets, Sought sought = Sought::Boxes);

    const Sheets& sheets_;
    Sought sought_;
    std::vector<Points> of_cloths_;  ///< n x 3 of each [m]
    Points x_;                       ///< the same, one after the other

private:
    void prepare(std::size_t frame) final;
    int check(std::size_t frame) final;

    std::vector<TrianglePair> found_;
};

/// Drape's own: boxes alone first.
void add_ours(Runners& runners, const Sheets& sheets);
void add_fcl(Runners& runners, const Sheets& sheets);
void add_bullet(Runners& runners, const Sheets& sheets);
void add_embree(Runners& runners, const Sheets& sheets);

}  // namespace drape::peers
