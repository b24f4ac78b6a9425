#pragma once

#include <memory>
#include <string>
#include <vector>

#include "drape/model/ball.h"
#include "drape/model/grid.h"

namespace drape::peers {

/// A way to find the triangles of a moving cloth that touch a ball.
class Method {
public:
    explicit Method(std::string name) : name_(std::move(name)) {}
    virtual ~Method() = default;
    Method(const Method&) = delete;
    Method& operator=(const Method&) = delete;

    [[nodiscard]] const std::string& name() const { return name_; }

    /// @param x n x 3 [m]
    virtual void start(const Grid& grid, const Points& x) = 0;

    /// Follows the cloth to its present positions.
    virtual void update(const Points& x) = 0;

    /// @param x as in the last `update`
    /// @param touched receives the triangles whose distance to the ball's centre is at most its radius, in any order
    virtual void query(const Points& x, const Ball& ball, std::vector<int>& touched) = 0;

private:
    std::string name_;
};

/// A library that finds candidates, which are then decided one by one.
class Peer : public Method {
public:
    using Method::Method;

    void query(const Points& x, const Ball& ball, std::vector<int>& touched) final;

protected:
    /// @param ball grown by what a bound or a position may be off
    /// @param triangles receives every triangle that touches it, each once, and perhaps more; empty before
    virtual void list_candidates(const Ball& ball, std::vector<int>& triangles) = 0;

    /// The rounding of one number in the library, as a share of it.
    [[nodiscard]] virtual Real epsilon() const = 0;

    Grid grid_;
};

using Methods = std::vector<std::unique_ptr<Method>>;

/// Drape's own: brute force first, which is no tree, then the trees.
void add_ours(Methods& methods);
void add_fcl(Methods& methods);
void add_bullet(Methods& methods);
void add_embree(Methods& methods);

}  // namespace drape::peers
