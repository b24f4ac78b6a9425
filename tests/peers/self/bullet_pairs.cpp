// Bullet 3.24: the tree of a soft body's faces, refitted as btSoftBody does it in every step, traversed against itself.

#include <BulletSoftBody/btSoftBody.h>
#include <BulletSoftBody/btSoftBodyHelpers.h>

#include <type_traits>

#include "pair_method.h"

namespace drape::peers {
namespace {

static_assert(std::is_same_v<btScalar, Real>);

/// Keeps the pairs of faces of two bodies, or of one.
struct CollectingFaces final : btDbvt::ICollide {
    void Process(const btDbvtNode* a, const btDbvtNode* b) override {
        const int first = number(*a, 0), second = number(*b, 1);
        if (!sheets.share_particle(first, second)) found.push_back(in_order(first, second));
    }

    [[nodiscard]] int number(const btDbvtNode& leaf, std::size_t body) const {
        const auto* const face = static_cast<const btSoftBody::Face*>(leaf.data);
        return first_triangles[body] + static_cast<int>(face - first_faces[body]);
    }

    CollectingFaces(const Sheets& of, std::vector<TrianglePair>& pairs) : sheets(of), found(pairs) {}

    const Sheets& sheets;
    std::vector<TrianglePair>& found;
    std::array<int, 2> first_triangles{};
    std::array<const btSoftBody::Face*, 2> first_faces{};
};

/// One body a cloth: btSoftBody's tree grows by neighbours, and is never done where there are several sheets.
class BulletFaces final : public PairMethod {
public:
    explicit BulletFaces(std::string name) : PairMethod(std::move(name), Sought::Boxes) {}

    void start(const Sheets& sheets, const SheetFrame& frame) override {
        sheets_ = &sheets;
        for (std::size_t c = 0; c < sheets.grids.size(); ++c) {
            bodies_.push_back(make_body(sheets.grids[c], frame.of_cloths[c]));
        }
        update(frame);
    }

    void update(const SheetFrame& frame) override {
        for (std::size_t c = 0; c < bodies_.size(); ++c) {
            btSoftBody& body = *bodies_[c];
            const Points& x = frame.of_cloths[c];
            for (int p = 0; p < body.m_nodes.size(); ++p) body.m_nodes[p].m_x.setValue(x(p, 0), x(p, 1), x(p, 2));
            body.updateFace(body.m_fdbvt.m_root, false, true);
        }
    }

    void query(std::vector<TrianglePair>& found) override {
        CollectingFaces collecting(*sheets_, found);
        for (std::size_t a = 0; a < bodies_.size(); ++a) {
            for (std::size_t b = a; b < bodies_.size(); ++b) {
                collecting.first_triangles = {sheets_->first_triangles[a], sheets_->first_triangles[b]};
                collecting.first_faces = {&bodies_[a]->m_faces[0], &bodies_[b]->m_faces[0]};
                btDbvt& tree = bodies_[a]->m_fdbvt;
                if (a == b) tree.selfCollideTT(tree.m_root, collecting);
                if (a < b) tree.collideTTpersistentStack(tree.m_root, bodies_[b]->m_fdbvt.m_root, collecting);
            }
        }
    }

private:
    [[nodiscard]] std::unique_ptr<btSoftBody> make_body(const Grid& grid, const Points& x) {
        std::vector<btScalar> vertices;
        for (Eigen::Index p = 0; p < x.rows(); ++p) {
            for (int axis = 0; axis < 3; ++axis) vertices.push_back(x(p, axis));
        }
        std::vector<int> indices;
        for (int t = 0; t < grid.triangles(); ++t) {
            for (const int corner : grid.triangle_corners(t)) indices.push_back(corner);
        }
        std::unique_ptr<btSoftBody> body(
            btSoftBodyHelpers::CreateFromTriMesh(world_, vertices.data(), indices.data(), grid.triangles(), false));
        // Grown by what a sum may lose to rounding
        body->m_sst.radmrg = sheets_->thickness / 2 + Real(1e-14);
        body->initializeFaceTree();
        return body;
    }

    const Sheets* sheets_ = nullptr;
    btSoftBodyWorldInfo world_;
    std::vector<std::unique_ptr<btSoftBody>> bodies_;
};

}  // namespace

void add_bullet_pairs(PairMethods& methods) {
    methods.push_back(std::make_unique<BulletFaces>("Bullet btSoftBody faces"));
}

}  // namespace drape::peers
