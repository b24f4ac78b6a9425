#include "drape/bounds/broad_phase.h"
#include "drape/contact/detection.h"
#include "method.h"

namespace drape::peers {
namespace {

class Ours final : public Method {
public:
    Ours(std::string name, const BroadPhaseParameters& parameters) : Method(std::move(name)), parameters_(parameters) {}

    void start(const Grid& grid, const Points& x) override {
        grid_ = grid;
        tree_ = make_broad_phase(parameters_, grid);
        tree_->build(x);
    }

    void update(const Points& x) override { tree_->build(x); }

    void query(const Points& x, const Ball& ball, std::vector<int>& touched) override {
        tree_->query(ball, found_);
        find_touched_triangles(grid_, x, ball, 0, found_.cells, touched, Kernels::Vector);
    }

private:
    BroadPhaseParameters parameters_;
    Grid grid_;
    std::unique_ptr<BroadPhase> tree_;
    Candidates found_;
};

}  // namespace

void add_ours(Methods& methods) {
    const auto add = [&methods](VolumeKind volume, UpdateKind update) {
        const auto v = static_cast<std::size_t>(volume), u = static_cast<std::size_t>(update);
        const std::string how = volume == VolumeKind::Brute ? "" : " " + names_of<UpdateKind>()[u];
        methods.push_back(std::make_unique<Ours>("Drape " + names_of<VolumeKind>()[v] + how,
                                                 BroadPhaseParameters{.volume = volume, .update = update}));
    };
    add(VolumeKind::Brute, UpdateKind::Rebuild);
    for (const UpdateKind update : {UpdateKind::Merge, UpdateKind::Rebuild}) {
        for (const VolumeKind volume : {VolumeKind::Sphere, VolumeKind::Aabb, VolumeKind::Kdop18, VolumeKind::Obb}) {
            add(volume, update);
        }
    }
}

}  // namespace drape::peers
