// Embree: a tree of wide nodes over triangles, or over quads, which a cell's two triangles fit into; always single
// precision, one thread.

#include <rtcore.h>

#include "drape/base/input_error.h"
#include "method.h"

namespace drape::peers {
namespace {

enum class Shape { Triangles, Quads };

class EmbreeTree final : public Peer {
public:
    EmbreeTree(std::string name, Shape shape, RTCBuildQuality quality)
        : Peer(std::move(name)), shape_(shape), quality_(quality) {}

    ~EmbreeTree() override {
        rtcReleaseGeometry(mesh_);
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }

    void start(const Grid& grid, const Points& x) override {
        grid_ = grid;
        device_ = rtcNewDevice("threads=1");
        if (device_ == nullptr) throw RunError("Embree does not start");
        scene_ = rtcNewScene(device_);
        // Dynamic, as a mesh that is refitted must be; compact, so that the leaves hold no copies of the corners, which
        // makes the refit of triangles twice as fast
        rtcSetSceneFlags(scene_, static_cast<RTCSceneFlags>(RTC_SCENE_FLAG_DYNAMIC | RTC_SCENE_FLAG_COMPACT));
        rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_LOW);
        mesh_ = rtcNewGeometry(device_, shape_ == Shape::Quads ? RTC_GEOMETRY_TYPE_QUAD : RTC_GEOMETRY_TYPE_TRIANGLE);
        rtcSetGeometryBuildQuality(mesh_, quality_);
        corners_ = static_cast<float*>(rtcSetNewGeometryBuffer(mesh_, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                               3 * sizeof(float), size(grid.particles())));
        shape_ == Shape::Quads ? list_quads() : list_triangles();
        take(x);
        rtcCommitGeometry(mesh_);
        rtcAttachGeometry(scene_, mesh_);
        rtcCommitScene(scene_);
    }

    void update(const Points& x) override {
        take(x);
        rtcUpdateGeometryBuffer(mesh_, RTC_BUFFER_TYPE_VERTEX, 0);
        rtcCommitGeometry(mesh_);
        rtcCommitScene(scene_);
    }

protected:
    void list_candidates(const Ball& ball, std::vector<int>& triangles) override {
        RTCPointQuery query{};
        query.x = static_cast<float>(ball.centre[0]);
        query.y = static_cast<float>(ball.centre[1]);
        query.z = static_cast<float>(ball.centre[2]);
        query.radius = static_cast<float>(ball.radius);
        RTCPointQueryContext context;
        rtcInitPointQueryContext(&context);
        rtcPointQuery(scene_, &query, &context, shape_ == Shape::Quads ? collect_quad : collect_triangle, &triangles);
    }

    [[nodiscard]] Real epsilon() const override { return Real(std::numeric_limits<float>::epsilon()); }

private:
    static std::size_t size(int n) { return static_cast<std::size_t>(n); }

    unsigned* new_indices(RTCFormat format, unsigned corners, int shapes) {
        return static_cast<unsigned*>(
            rtcSetNewGeometryBuffer(mesh_, RTC_BUFFER_TYPE_INDEX, 0, format, corners * sizeof(unsigned), size(shapes)));
    }

    void list_triangles() {
        unsigned* next = new_indices(RTC_FORMAT_UINT3, 3, grid_.triangles());
        for (int t = 0; t < grid_.triangles(); ++t) {
            for (const int corner : grid_.triangle_corners(t)) *next++ = static_cast<unsigned>(corner);
        }
    }

    void list_quads() {
        unsigned* next = new_indices(RTC_FORMAT_UINT4, 4, grid_.cells());
        for (int cell = 0; cell < grid_.cells(); ++cell) {
            const int a = grid_.cell_corner(cell);
            for (const int corner : {a, a + grid_.nx, a + grid_.nx + 1, a + 1}) *next++ = static_cast<unsigned>(corner);
        }
    }

    void take(const Points& x) {
        float* next = corners_;
        for (int p = 0; p < grid_.particles(); ++p) {
            for (int axis = 0; axis < 3; ++axis) *next++ = static_cast<float>(x(p, axis));
        }
    }

    static bool collect_triangle(RTCPointQueryFunctionArguments* found) {
        static_cast<std::vector<int>*>(found->userPtr)->push_back(static_cast<int>(found->primID));
        return false;
    }

    static bool collect_quad(RTCPointQueryFunctionArguments* found) {
        const int first = 2 * static_cast<int>(found->primID);
        auto& triangles = *static_cast<std::vector<int>*>(found->userPtr);
        triangles.push_back(first);
        triangles.push_back(first + 1);
        return false;
    }

    Shape shape_;
    RTCBuildQuality quality_;
    RTCDevice device_ = nullptr;
    RTCScene scene_ = nullptr;
    RTCGeometry mesh_ = nullptr;
    float* corners_ = nullptr;  ///< Embree's: x, y, z of each particle
};

}  // namespace

void add_embree(Methods& methods) {
    const auto add = [&methods](const std::string& name, Shape shape, RTCBuildQuality quality) {
        methods.push_back(std::make_unique<EmbreeTree>("Embree " + name, shape, quality));
    };
    add("triangles refit", Shape::Triangles, RTC_BUILD_QUALITY_REFIT);
    add("triangles rebuild", Shape::Triangles, RTC_BUILD_QUALITY_LOW);
    add("quads refit", Shape::Quads, RTC_BUILD_QUALITY_REFIT);
    add("quads rebuild", Shape::Quads, RTC_BUILD_QUALITY_LOW);
}

}  // namespace drape::peers
