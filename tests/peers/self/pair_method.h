#pragma once

#include <memory>
#include <string>
#include <vector>

#include "sheets.h"

namespace drape::peers {

/// What a method must find.
enum class Sought {
    Boxes,  ///< every pair of triangles whose grown boxes overlap
    Near    ///< of these, at least those that are no farther apart than the thickness: what narrower volumes leave
};

/// A way to find the pairs of triangles of cloths that may touch themselves and each other.
class PairMethod {
public:
    PairMethod(std::string name, Sought sought) : name_(std::move(name)), sought_(sought) {}
    virtual ~PairMethod() = default;
    PairMethod(const PairMethod&) = delete;
    PairMethod& operator=(const PairMethod&) = delete;

    [[nodiscard]] const std::string& name() const { return name_; }
    [[nodiscard]] Sought sought() const { return sought_; }

    /// @param sheets outlives the method
    virtual void start(const Sheets& sheets, const SheetFrame& frame) = 0;

    /// Follows the cloths to their present positions.
    virtual void update(const SheetFrame& frame) = 0;

    /// @param found receives pairs that share no particle, each once, in any order; empty before
    virtual void query(std::vector<TrianglePair>& found) = 0;

private:
    std::string name_;
    Sought sought_;
};

using PairMethods = std::vector<std::unique_ptr<PairMethod>>;

/// Drape's own: boxes alone first.
void add_our_pairs(PairMethods& methods);
void add_fcl_pairs(PairMethods& methods);
void add_bullet_pairs(PairMethods& methods);
void add_embree_pairs(PairMethods& methods);

}  // namespace drape::peers
