// FCL 0.7: one bounding volume a triangle and a binary tree over them, traversed with a ball or against itself; and its
// manager of many objects, here one a triangle.

#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/geometry/shape/utility.h>
#include <fcl/narrowphase/detail/traversal/collision/bvh_collision_traversal_node.h>
#include <fcl/narrowphase/detail/traversal/collision/bvh_shape_collision_traversal_node.h>
#include <fcl/narrowphase/detail/traversal/collision_node.h>

#include "ball_race.h"
#include "pair_race.h"

namespace drape::peers {
namespace {

using Box = fcl::AABB<Real>;

/// FCL's tree over the triangles of a mesh.
template <class Volume>
class Mesh : public fcl::BVHModel<Volume> {
public:
    Mesh(const Points& x, const std::vector<std::array<int, 3>>& triangles) {
        std::vector<fcl::Vector3<Real>> places;
        for (Eigen::Index p = 0; p < x.rows(); ++p) places.push_back(x.row(p).transpose());
        std::vector<fcl::Triangle> faces;
        for (const auto& [a, b, c] : triangles) faces.emplace_back(a, b, c);
        this->beginModel(static_cast<int>(faces.size()), static_cast<int>(places.size()));
        this->addSubModel(places, faces);
        this->endModel();
    }

    /// `replace`, for `update` keeps the positions before and fits each volume about both, as continuous detection
    /// needs. Refitting bottom-up is FCL's faster way, top-down its tighter one.
    void follow(const Points& x, bool refit) {
        this->beginReplaceModel();
        for (Eigen::Index p = 0; p < x.rows(); ++p) this->replaceVertex(x.row(p).transpose());
        this->endReplaceModel(refit, true);
    }
};

/// FCL's own traversal, which ends at a leaf with the triangle's number in place of FCL's general test of two shapes.
template <class Volume>
struct CollectingTriangles final : fcl::detail::BVHShapeCollisionTraversalNode<Volume, fcl::Sphere<Real>> {
    void leafTesting(int node, int /*shape*/) const override {
        triangles->push_back(this->model1->getBV(node).primitiveId());
    }

    std::vector<int>* triangles = nullptr;
};

template <class Volume>
class FclTree final : public BallPeer {
public:
    FclTree(std::string name, const Motion& motion, bool refit)
        : BallPeer(std::move(name), motion), refit_(refit), mesh_(x_, motion.corners) {}

    void update() override { mesh_.follow(x_, refit_); }

private:
    void list_candidates(const Ball& ball, std::vector<int>& triangles) override {
        const fcl::Sphere<Real> sphere(ball.radius);
        fcl::Transform3<Real> place = fcl::Transform3<Real>::Identity();
        place.translation() = ball.centre;
        CollectingTriangles<Volume> traversal;
        traversal.model1 = &mesh_;
        traversal.model2 = &sphere;
        traversal.tf2 = place;
        traversal.triangles = &triangles;
        fcl::computeBV(sphere, place, traversal.model2_bv);
        fcl::detail::collide(&traversal);
    }

    bool refit_;
    Mesh<Volume> mesh_;
};

/// FCL's own traversal of a tree against itself. Its boxes are those of the triangles, so that they are compared with
/// the thickness between them; a leaf ends with its number in place of FCL's test of two triangles.
struct CollectingPairs final : fcl::detail::BVHCollisionTraversalNode<Box> {
    [[nodiscard]] bool BVTesting(int a, int b) const override {
        const Box &one = model1->getBV(a).bv, &two = model2->getBV(b).bv;
        return !meet({one.min_, one.max_}, {two.min_, two.max_}, thickness);
    }

    void leafTesting(int a, int b) const override {
        method->keep(model1->getBV(a).primitiveId(), model2->getBV(b).primitiveId());
    }

    PairMethod* method = nullptr;
    Real thickness = 0;
};

class FclSelfTree final : public PairMethod {
public:
    FclSelfTree(std::string name, const Sheets& sheets, bool refit)
        : PairMethod(std::move(name), sheets), refit_(refit), mesh_(x_, sheets.corners) {}

    void update() override { mesh_.follow(x_, refit_); }

    void query() override {
        CollectingPairs traversal;
        traversal.model1 = traversal.model2 = &mesh_;
        traversal.method = this;
        traversal.thickness = sheets_.thickness;
        fcl::detail::selfCollide(&traversal);
    }

private:
    bool refit_;
    Mesh<Box> mesh_;
};

/// A triangle as FCL's manager knows it: a box and nothing else.
struct BoxOnly final : fcl::CollisionGeometry<Real> {
    void computeLocalAABB() override {}
};

class FclManager final : public PairMethod {
public:
    FclManager(std::string name, const Sheets& sheets) : PairMethod(std::move(name), sheets) {
        for (int t = 0; t < sheets.triangles(); ++t) {
            shapes_.push_back(std::make_shared<BoxOnly>());
            objects_.push_back(std::make_unique<fcl::CollisionObject<Real>>(shapes_.back()));
            objects_.back()->setUserData(reinterpret_cast<void*>(static_cast<std::intptr_t>(t)));
        }
        take_boxes();
        std::vector<fcl::CollisionObject<Real>*> all;
        for (const auto& object : objects_) all.push_back(object.get());
        manager_.registerObjects(all);
        manager_.setup();
    }

    void update() override {
        take_boxes();
        manager_.update();
    }

    void query() override { manager_.collide(this, collect); }

private:
    /// Boxes are grown by half of the thickness, and by what that may lose to rounding.
    void take_boxes() {
        make_boxes(sheets_, x_, boxes_);
        const Vec3 reach = Vec3::Constant(sheets_.thickness / 2 + rounding);
        for (std::size_t t = 0; t < boxes_.size(); ++t) {
            shapes_[t]->aabb_local = Box(boxes_[t].low - reach, boxes_[t].high + reach);
            objects_[t]->computeAABB();
        }
    }

    static bool collect(fcl::CollisionObject<Real>* a, fcl::CollisionObject<Real>* b, void* self) {
        const auto number = [](const fcl::CollisionObject<Real>& object) {
            return static_cast<int>(reinterpret_cast<std::intptr_t>(object.getUserData()));
        };
        static_cast<FclManager*>(self)->keep(number(*a), number(*b));
        return false;
    }

    static constexpr Real rounding = Real(1e-14);  // [m]
    std::vector<Aabb> boxes_;
    std::vector<std::shared_ptr<BoxOnly>> shapes_;
    std::vector<std::unique_ptr<fcl::CollisionObject<Real>>> objects_;
    fcl::DynamicAABBTreeCollisionManager<Real> manager_;
};

template <class Volume>
void add(Runners& runners, const Motion& motion, const std::string& volume) {
    runners.push_back(std::make_unique<FclTree<Volume>>("FCL " + volume + " refit", motion, true));
    runners.push_back(std::make_unique<FclTree<Volume>>("FCL " + volume + " rebuild", motion, false));
}

}  // namespace

void add_fcl(Runners& runners, const Motion& motion) {
    add<Box>(runners, motion, "AABB");
    add<fcl::KDOP<Real, 18>>(runners, motion, "k-DOP 18");
    add<fcl::OBB<Real>>(runners, motion, "OBB");
}

void add_fcl(Runners& runners, const Sheets& sheets) {
    runners.push_back(std::make_unique<FclSelfTree>("FCL BVHModel refit", sheets, true));
    runners.push_back(std::make_unique<FclSelfTree>("FCL BVHModel rebuild", sheets, false));
    runners.push_back(std::make_unique<FclManager>("FCL DynamicAABBTree manager", sheets));
}

}  // namespace drape::peers
