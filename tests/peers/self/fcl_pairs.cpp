// FCL 0.7: its tree of the triangles of one mesh, traversed against itself, and its manager of many objects, here one a
// triangle.

#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/narrowphase/detail/traversal/collision/bvh_collision_traversal_node.h>
#include <fcl/narrowphase/detail/traversal/collision_node.h>

#include "pair_method.h"

namespace drape::peers {
namespace {

using Box = fcl::AABB<Real>;

/// FCL's own traversal of a tree against itself. Its boxes are those of the triangles, so that they are compared with
/// the thickness between them; a leaf ends with its number in place of FCL's test of two triangles.
struct CollectingPairs final : fcl::detail::BVHCollisionTraversalNode<Box> {
    [[nodiscard]] bool BVTesting(int a, int b) const override {
        const Box &one = model1->getBV(a).bv, &two = model2->getBV(b).bv;
        return !meet({one.min_, one.max_}, {two.min_, two.max_}, sheets->thickness);
    }

    void leafTesting(int a, int b) const override {
        const int first = model1->getBV(a).primitiveId(), second = model2->getBV(b).primitiveId();
        if (!sheets->share_particle(first, second)) found->push_back(in_order(first, second));
    }

    const Sheets* sheets = nullptr;
    std::vector<TrianglePair>* found = nullptr;
};

class FclMesh final : public PairMethod {
public:
    FclMesh(std::string name, bool refit) : PairMethod(std::move(name), Sought::Boxes), refit_(refit) {}

    void start(const Sheets& sheets, const SheetFrame& frame) override {
        sheets_ = &sheets;
        std::vector<fcl::Vector3<Real>> vertices;
        for (Eigen::Index p = 0; p < frame.x.rows(); ++p) vertices.push_back(frame.x.row(p).transpose());
        std::vector<fcl::Triangle> triangles;
        for (const auto& [a, b, c] : sheets.corners) triangles.emplace_back(a, b, c);
        model_.beginModel(sheets.triangles(), static_cast<int>(frame.x.rows()));
        model_.addSubModel(vertices, triangles);
        model_.endModel();
    }

    void update(const SheetFrame& frame) override {
        model_.beginReplaceModel();
        for (Eigen::Index p = 0; p < frame.x.rows(); ++p) model_.replaceVertex(frame.x.row(p).transpose());
        model_.endReplaceModel(refit_, true);
    }

    void query(std::vector<TrianglePair>& found) override {
        CollectingPairs traversal;
        traversal.model1 = traversal.model2 = &model_;
        traversal.sheets = sheets_;
        traversal.found = &found;
        fcl::detail::selfCollide(&traversal);
    }

private:
    bool refit_;
    const Sheets* sheets_ = nullptr;
    fcl::BVHModel<Box> model_;
};

/// A triangle as FCL's manager knows it: a box and nothing else.
struct BoxOnly final : fcl::CollisionGeometry<Real> {
    void computeLocalAABB() override {}
};

class FclManager final : public PairMethod {
public:
    explicit FclManager(std::string name) : PairMethod(std::move(name), Sought::Boxes) {}

    void start(const Sheets& sheets, const SheetFrame& frame) override {
        sheets_ = &sheets;
        for (int t = 0; t < sheets.triangles(); ++t) {
            shapes_.push_back(std::make_shared<BoxOnly>());
            objects_.push_back(std::make_unique<fcl::CollisionObject<Real>>(shapes_.back()));
            objects_.back()->setUserData(reinterpret_cast<void*>(static_cast<std::intptr_t>(t)));
        }
        take(frame);
        std::vector<fcl::CollisionObject<Real>*> all;
        for (const auto& object : objects_) all.push_back(object.get());
        manager_.registerObjects(all);
        manager_.setup();
    }

    void update(const SheetFrame& frame) override {
        take(frame);
        manager_.update();
    }

    void query(std::vector<TrianglePair>& found) override {
        found_ = &found;
        manager_.collide(this, collect);
    }

private:
    /// Boxes are grown by half of the thickness, and by what that may lose to rounding.
    void take(const SheetFrame& frame) {
        make_boxes(*sheets_, frame.x, boxes_);
        const Vec3 reach = Vec3::Constant(sheets_->thickness / 2 + rounding);
        for (std::size_t t = 0; t < boxes_.size(); ++t) {
            shapes_[t]->aabb_local = Box(boxes_[t].low - reach, boxes_[t].high + reach);
            objects_[t]->computeAABB();
        }
    }

    static int number(const fcl::CollisionObject<Real>& object) {
        return static_cast<int>(reinterpret_cast<std::intptr_t>(object.getUserData()));
    }

    static bool collect(fcl::CollisionObject<Real>* a, fcl::CollisionObject<Real>* b, void* self) {
        const FclManager& manager = *static_cast<FclManager*>(self);
        const int first = number(*a), second = number(*b);
        if (!manager.sheets_->share_particle(first, second)) manager.found_->push_back(in_order(first, second));
        return false;
    }

    static constexpr Real rounding = 1e-14;  // [m]
    const Sheets* sheets_ = nullptr;
    std::vector<Aabb> boxes_;
    std::vector<std::shared_ptr<BoxOnly>> shapes_;
    std::vector<std::unique_ptr<fcl::CollisionObject<Real>>> objects_;
    fcl::DynamicAABBTreeCollisionManager<Real> manager_;
    std::vector<TrianglePair>* found_ = nullptr;
};

}  // namespace

void add_fcl_pairs(PairMethods& methods) {
    methods.push_back(std::make_unique<FclMesh>("FCL BVHModel refit", true));
    methods.push_back(std::make_unique<FclMesh>("FCL BVHModel rebuild", false));
    methods.push_back(std::make_unique<FclManager>("FCL DynamicAABBTree manager"));
}

}  // namespace drape::peers
