// Bullet 3.24: one box a triangle, in btDbvt, whose nodes are linked, or btOptimizedBvh, whose nodes lie in an array
// and have 16 bits a coordinate. In the precision of the program.

#include <BulletCollision/BroadphaseCollision/btDbvt.h>
#include <BulletCollision/CollisionShapes/btOptimizedBvh.h>
#include <BulletCollision/CollisionShapes/btTriangleIndexVertexArray.h>

#include <cstdint>
#include <type_traits>

#include "method.h"

namespace drape::peers {
namespace {

static_assert(std::is_same_v<btScalar, Real>);

btVector3 vector(const Vec3& v) { return {v[0], v[1], v[2]}; }

class BulletPeer : public Peer {
public:
    using Peer::Peer;

protected:
    [[nodiscard]] Real epsilon() const override { return std::numeric_limits<Real>::epsilon(); }
};

class Dbvt final : public BulletPeer {
public:
    /// One leaf after the other is taken out and put in again (`btDbvt::update`), or the boxes are made anew from the
    /// leaves up and the tree stays as it is (as `btSoftBody::updateFaceTree` does).
    enum class Update { Leaves, Refit };

    Dbvt(std::string name, Update update) : BulletPeer(std::move(name)), update_(update) {}

    void start(const Grid& grid, const Points& x) override {
        grid_ = grid;
        corners_.resize(static_cast<std::size_t>(grid.particles()));
        take(x);
        for (int t = 0; t < grid.triangles(); ++t) {
            leaves_.push_back(tree_.insert(box(t), reinterpret_cast<void*>(static_cast<std::intptr_t>(t))));
        }
        tree_.optimizeTopDown();
    }

    void update(const Points& x) override {
        take(x);
        if (update_ == Update::Refit) {
            refit(*tree_.m_root);
            return;
        }
        for (int t = 0; t < grid_.triangles(); ++t) {
            btDbvtVolume volume = box(t);
            tree_.update(leaves_[static_cast<std::size_t>(t)], volume);
        }
    }

protected:
    void list_candidates(const Ball& ball, std::vector<int>& triangles) override {
        struct Collecting final : btDbvt::ICollide {
            void Process(const btDbvtNode* leaf) override { triangles->push_back(number(*leaf)); }
            std::vector<int>* triangles = nullptr;
        } collecting;
        collecting.triangles = &triangles;
        tree_.collideTVNoStackAlloc(tree_.m_root, btDbvtVolume::FromCR(vector(ball.centre), ball.radius), stack_,
                                    collecting);
    }

private:
    static int number(const btDbvtNode& leaf) { return static_cast<int>(reinterpret_cast<std::intptr_t>(leaf.data)); }

    void take(const Points& x) {
        for (int p = 0; p < grid_.particles(); ++p) {
            corners_[static_cast<std::size_t>(p)].setValue(x(p, 0), x(p, 1), x(p, 2));
        }
    }

    [[nodiscard]] btDbvtVolume box(int triangle) const {
        const auto [a, b, c] = grid_.triangle_corners(triangle);
        const auto at = [this](int p) -> const btVector3& { return corners_[static_cast<std::size_t>(p)]; };
        btVector3 low = at(a), high = at(a);
        low.setMin(at(b));
        low.setMin(at(c));
        high.setMax(at(b));
        high.setMax(at(c));
        return btDbvtVolume::FromMM(low, high);
    }

    void refit(btDbvtNode& node) {
        if (node.isleaf()) {
            node.volume = box(number(node));
            return;
        }
        refit(*node.childs[0]);
        refit(*node.childs[1]);
        Merge(node.childs[0]->volume, node.childs[1]->volume, node.volume);
    }

    Update update_;
    std::vector<btVector3> corners_;
    btDbvt tree_;
    std::vector<btDbvtNode*> leaves_;  ///< by triangle
    btNodeStack stack_;
};

/// The tree inside btBvhTriangleMeshShape, without the shape, whose refit goes over all triangles six more times for
/// its own box. Only trees with 16 bits a coordinate can be refitted.
class OptimizedBvh final : public BulletPeer {
public:
    using BulletPeer::BulletPeer;

    void start(const Grid& grid, const Points& x) override {
        grid_ = grid;
        for (int t = 0; t < grid.triangles(); ++t) {
            for (const int corner : grid.triangle_corners(t)) indices_.push_back(corner);
        }
        corners_.resize(static_cast<std::size_t>(3 * grid.particles()));
        take(x);
        btIndexedMesh mesh;
        mesh.m_numTriangles = grid.triangles();
        mesh.m_triangleIndexBase = reinterpret_cast<const unsigned char*>(indices_.data());
        mesh.m_triangleIndexStride = 3 * sizeof(int);
        mesh.m_numVertices = grid.particles();
        mesh.m_vertexBase = reinterpret_cast<const unsigned char*>(corners_.data());
        mesh.m_vertexStride = 3 * sizeof(btScalar);
        mesh_.addIndexedMesh(mesh);
        tree_.build(&mesh_, true, low_, high_);
    }

    void update(const Points& x) override {
        take(x);
        tree_.refit(&mesh_, low_, high_);
    }

protected:
    void list_candidates(const Ball& ball, std::vector<int>& triangles) override {
        struct Collecting final : btNodeOverlapCallback {
            void processNode(int /*part*/, int triangle) override { triangles->push_back(triangle); }
            std::vector<int>* triangles = nullptr;
        } collecting;
        collecting.triangles = &triangles;
        const btVector3 centre = vector(ball.centre), reach(ball.radius, ball.radius, ball.radius);
        tree_.reportAabbOverlappingNodex(&collecting, centre - reach, centre + reach);
    }

private:
    void take(const Points& x) {
        btScalar* next = corners_.data();
        for (int p = 0; p < grid_.particles(); ++p) {
            for (int axis = 0; axis < 3; ++axis) *next++ = x(p, axis);
        }
        low_ = vector(x.colwise().minCoeff().transpose());
        high_ = vector(x.colwise().maxCoeff().transpose());
    }

    std::vector<int> indices_;
    std::vector<btScalar> corners_;  ///< x, y, z of each particle
    btTriangleIndexVertexArray mesh_;
    btOptimizedBvh tree_;
    btVector3 low_, high_;
};

}  // namespace

void add_bullet(Methods& methods) {
    methods.push_back(std::make_unique<Dbvt>("Bullet btDbvt update", Dbvt::Update::Leaves));
    methods.push_back(std::make_unique<Dbvt>("Bullet btDbvt refit", Dbvt::Update::Refit));
    methods.push_back(std::make_unique<OptimizedBvh>("Bullet btOptimizedBvh refit"));
}

}  // namespace drape::peers
