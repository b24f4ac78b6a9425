// FCL 0.7: one bounding volume a triangle, a binary tree over them.

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/geometry/shape/utility.h>
#include <fcl/narrowphase/detail/traversal/collision/bvh_shape_collision_traversal_node.h>
#include <fcl/narrowphase/detail/traversal/collision_node.h>

#include "method.h"

namespace drape::peers {
namespace {

/// FCL's own traversal, which ends at a leaf with the triangle's number in place of FCL's general test of two shapes.
template <class Volume>
struct Collecting final : fcl::detail::BVHShapeCollisionTraversalNode<Volume, fcl::Sphere<Real>> {
    void leafTesting(int node, int /*shape*/) const override {
        triangles->push_back(this->model1->getBV(node).primitiveId());
    }

    std::vector<int>* triangles = nullptr;
};

template <class Volume>
class FclTree final : public Peer {
public:
    FclTree(std::string name, bool refit) : Peer(std::move(name)), refit_(refit) {}

    void start(const Grid& grid, const Points& x) override {
        grid_ = grid;
        model_.beginModel(grid.triangles(), grid.particles());
        std::vector<fcl::Vector3<Real>> corners;
        for (int p = 0; p < grid.particles(); ++p) corners.push_back(x.row(p).transpose());
        std::vector<fcl::Triangle> triangles;
        for (int t = 0; t < grid.triangles(); ++t) {
            const auto [a, b, c] = grid.triangle_corners(t);
            triangles.emplace_back(a, b, c);
        }
        model_.addSubModel(corners, triangles);
        model_.endModel();
    }

    /// `replace`, for `update` keeps the positions before and fits each volume about both, as continuous detection
    /// needs. Refitting bottom-up is FCL's faster way, top-down its tighter one.
    void update(const Points& x) override {
        model_.beginReplaceModel();
        for (int p = 0; p < grid_.particles(); ++p) model_.replaceVertex(x.row(p).transpose());
        model_.endReplaceModel(refit_, true);
    }

protected:
    void list_candidates(const Ball& ball, std::vector<int>& triangles) override {
        const fcl::Sphere<Real> sphere(ball.radius);
        fcl::Transform3<Real> place = fcl::Transform3<Real>::Identity();
        place.translation() = ball.centre;
        Collecting<Volume> traversal;
        traversal.model1 = &model_;
        traversal.model2 = &sphere;
        traversal.tf2 = place;
        traversal.triangles = &triangles;
        fcl::computeBV(sphere, place, traversal.model2_bv);
        fcl::detail::collide(&traversal);
    }

    [[nodiscard]] Real epsilon() const override { return std::numeric_limits<Real>::epsilon(); }

private:
    bool refit_;
    fcl::BVHModel<Volume> model_;
};

template <class Volume>
void add(Methods& methods, const std::string& volume) {
    methods.push_back(std::make_unique<FclTree<Volume>>("FCL " + volume + " refit", true));
    methods.push_back(std::make_unique<FclTree<Volume>>("FCL " + volume + " rebuild", false));
}

}  // namespace

void add_fcl(Methods& methods) {
    add<fcl::AABB<Real>>(methods, "AABB");
    add<fcl::KDOP<Real, 18>>(methods, "k-DOP 18");
    add<fcl::OBB<Real>>(methods, "OBB");
}

}  // namespace drape::peers
