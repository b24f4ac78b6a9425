// Bullet 3.24, in the precision of the program. With a ball: one box a triangle, in btDbvt, whose nodes are linked, or
// btOptimizedBvh, whose nodes lie in an array and have 16 bits a coordinate. Of pairs: the tree of a soft body's faces,
// refitted as btSoftBody does it in every step, traversed against itself.

#include <BulletCollision/BroadphaseCollision/btDbvt.h>
#include <BulletCollision/CollisionShapes/btOptimizedBvh.h>
#include <BulletCollision/CollisionShapes/btTriangleIndexVertexArray.h>
#include <BulletSoftBody/btSoftBody.h>
#include <BulletSoftBody/btSoftBodyHelpers.h>

#include <cstdint>
#include <type_traits>

#include "ball_race.h"
#include "pair_race.h"

namespace drape::peers {
namespace {

static_assert(std::is_same_v<btScalar, Real>);

/// x, y, z of each particle in turn.
using RowPoints = Eigen::Matrix<Real, Eigen::Dynamic, 3, Eigen::RowMajor>;

btVector3 vector(const Vec3& v) { return {v[0], v[1], v[2]}; }

class Dbvt final : public BallPeer {
public:
    /// One leaf after the other is taken out and put in again (`btDbvt::update`), or the boxes are made anew from the
    /// leaves up and the tree stays as it is (as `btSoftBody::updateFaceTree` does).
    enum class Update { Leaves, Refit };

    Dbvt(std::string name, const Motion& motion, Update update) : BallPeer(std::move(name), motion), update_(update) {
        corners_.resize(static_cast<std::size_t>(x_.rows()));
        take_corners();
        for (int t = 0; t < motion.grid.triangles(); ++t) {
            leaves_.push_back(tree_.insert(box(t), reinterpret_cast<void*>(static_cast<std::intptr_t>(t))));
        }
        tree_.optimizeTopDown();
    }

    void update() override {
        take_corners();
        if (update_ == Update::Refit) {
            refit(*tree_.m_root);
            return;
        }
        for (int t = 0; t < motion_.grid.triangles(); ++t) {
            btDbvtVolume volume = box(t);
            tree_.update(leaves_[static_cast<std::size_t>(t)], volume);
        }
    }

private:
    void list_candidates(const Ball& ball, std::vector<int>& triangles) override {
        struct Collecting final : btDbvt::ICollide {
            void Process(const btDbvtNode* leaf) override { triangles->push_back(number(*leaf)); }
            std::vector<int>* triangles = nullptr;
        } collecting;
        collecting.triangles = &triangles;
        tree_.collideTVNoStackAlloc(tree_.m_root, btDbvtVolume::FromCR(vector(ball.centre), ball.radius), stack_,
                                    collecting);
    }

    static int number(const btDbvtNode& leaf) { return static_cast<int>(reinterpret_cast<std::intptr_t>(leaf.data)); }

    void take_corners() {
        for (Eigen::Index p = 0; p < x_.rows(); ++p) {
            corners_[static_cast<std::size_t>(p)].setValue(x_(p, 0), x_(p, 1), x_(p, 2));
        }
    }

    [[nodiscard]] btDbvtVolume box(int triangle) const {
        const auto [a, b, c] = motion_.corners[static_cast<std::size_t>(triangle)];
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
class OptimizedBvh final : public BallPeer {
public:
    OptimizedBvh(std::string name, const Motion& motion) : BallPeer(std::move(name), motion) {
        const Grid& grid = motion.grid;
        for (const auto& triangle : motion.corners) indices_.insert(indices_.end(), triangle.begin(), triangle.end());
        corners_.resize(static_cast<std::size_t>(3 * grid.particles()));
        take_corners();
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

    void update() override {
        take_corners();
        tree_.refit(&mesh_, low_, high_);
    }

private:
    void list_candidates(const Ball& ball, std::vector<int>& triangles) override {
        struct Collecting final : btNodeOverlapCallback {
            void processNode(int /*part*/, int triangle) override { triangles->push_back(triangle); }
            std::vector<int>* triangles = nullptr;
        } collecting;
        collecting.triangles = &triangles;
        const btVector3 centre = vector(ball.centre), reach(ball.radius, ball.radius, ball.radius);
        tree_.reportAabbOverlappingNodex(&collecting, centre - reach, centre + reach);
    }

    void take_corners() {
        Eigen::Map<RowPoints>(corners_.data(), x_.rows(), 3) = x_;
        low_ = vector(x_.colwise().minCoeff().transpose());
        high_ = vector(x_.colwise().maxCoeff().transpose());
    }

    std::vector<int> indices_;
    std::vector<btScalar> corners_;  ///< x, y, z of each particle
    btTriangleIndexVertexArray mesh_;
    btOptimizedBvh tree_;
    btVector3 low_, high_;
};

/// Keeps the pairs of faces of two bodies, or of one.
struct CollectingFaces final : btDbvt::ICollide {
    void Process(const btDbvtNode* a, const btDbvtNode* b) override { method.keep(number(*a, 0), number(*b, 1)); }

    [[nodiscard]] int number(const btDbvtNode& leaf, std::size_t body) const {
        const auto* const face = static_cast<const btSoftBody::Face*>(leaf.data);
        return first_triangles[body] + static_cast<int>(face - first_faces[body]);
    }

    explicit CollectingFaces(PairMethod& of) : method(of) {}

    PairMethod& method;
    std::array<int, 2> first_triangles{};
    std::array<const btSoftBody::Face*, 2> first_faces{};
};

/// One body a cloth: btSoftBody's tree grows by neighbours, and is never done where there are several sheets.
class BulletFaces final : public PairMethod {
public:
    BulletFaces(std::string name, const Sheets& sheets) : PairMethod(std::move(name), sheets) {
        for (std::size_t c = 0; c < sheets.grids.size(); ++c) {
            bodies_.push_back(make_body(sheets.grids[c], of_cloths_[c]));
        }
        update();
    }

    void update() override {
        for (std::size_t c = 0; c < bodies_.size(); ++c) {
            btSoftBody& body = *bodies_[c];
            const Points& x = of_cloths_[c];
            for (int p = 0; p < body.m_nodes.size(); ++p) body.m_nodes[p].m_x.setValue(x(p, 0), x(p, 1), x(p, 2));
            body.updateFace(body.m_fdbvt.m_root, false, true);
        }
    }

    void query() override {
        CollectingFaces collecting(*this);
        for (std::size_t a = 0; a < bodies_.size(); ++a) {
            for (std::size_t b = a; b < bodies_.size(); ++b) {
                collecting.first_triangles = {sheets_.first_triangles[a], sheets_.first_triangles[b]};
                collecting.first_faces = {&bodies_[a]->m_faces[0], &bodies_[b]->m_faces[0]};
                btDbvt& tree = bodies_[a]->m_fdbvt;
                if (a == b) tree.selfCollideTT(tree.m_root, collecting);
                if (a < b) tree.collideTTpersistentStack(tree.m_root, bodies_[b]->m_fdbvt.m_root, collecting);
            }
        }
    }

private:
    [[nodiscard]] std::unique_ptr<btSoftBody> make_body(const Grid& grid, const Points& x) {
        const RowPoints vertices = x;
        std::vector<int> indices;
        for (int t = 0; t < grid.triangles(); ++t) {
            for (const int corner : grid.triangle_corners(t)) indices.push_back(corner);
        }
        std::unique_ptr<btSoftBody> body(
            btSoftBodyHelpers::CreateFromTriMesh(world_, vertices.data(), indices.data(), grid.triangles(), false));
        // Grown by what a sum may lose to rounding
        body->m_sst.radmrg = sheets_.thickness / 2 + Real(1e-14);
        body->initializeFaceTree();
        return body;
    }

    btSoftBodyWorldInfo world_;
    std::vector<std::unique_ptr<btSoftBody>> bodies_;
};

}  // namespace

void add_bullet(Runners& runners, const Motion& motion) {
    runners.push_back(std::make_unique<Dbvt>("Bullet btDbvt update", motion, Dbvt::Update::Leaves));
    runners.push_back(std::make_unique<Dbvt>("Bullet btDbvt refit", motion, Dbvt::Update::Refit));
    runners.push_back(std::make_unique<OptimizedBvh>("Bullet btOptimizedBvh refit", motion));
}

void add_bullet(Runners& runners, const Sheets& sheets) {
    runners.push_back(std::make_unique<BulletFaces>("Bullet btSoftBody faces", sheets));
}

}  // namespace drape::peers
