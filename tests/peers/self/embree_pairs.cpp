// Embree: rtcCollide of a scene with itself, whose triangles are a geometry of the user's, as in Embree's tutorial
// "collide"; single precision, one thread.

#include <rtcore.h>

#include "drape/base/input_error.h"
#include "pair_method.h"

namespace drape::peers {
namespace {

class EmbreePairs final : public PairMethod {
public:
    EmbreePairs(std::string name, RTCBuildQuality quality)
        : PairMethod(std::move(name), Sought::Boxes), quality_(quality) {}

    ~EmbreePairs() override {
        rtcReleaseGeometry(triangles_);
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }

    void start(const Sheets& sheets, const SheetFrame& frame) override {
        sheets_ = &sheets;
        device_ = rtcNewDevice("threads=1");
        if (device_ == nullptr) throw RunError("Embree does not start");
        scene_ = rtcNewScene(device_);
        rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_DYNAMIC);
        rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_LOW);
        triangles_ = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_USER);
        rtcSetGeometryBuildQuality(triangles_, quality_);
        rtcSetGeometryUserPrimitiveCount(triangles_, static_cast<unsigned>(sheets.triangles()));
        rtcSetGeometryUserData(triangles_, this);
        rtcSetGeometryBoundsFunction(triangles_, bound, nullptr);
        rtcAttachGeometry(scene_, triangles_);
        update(frame);
    }

    void update(const SheetFrame& frame) override {
        make_boxes(*sheets_, frame.x, boxes_);
        rtcCommitGeometry(triangles_);
        rtcCommitScene(scene_);
    }

    void query(std::vector<TrianglePair>& found) override {
        found_ = &found;
        rtcCollide(scene_, scene_, collect, this);
    }

private:
    /// Grown by half of the thickness, and outwards by what single precision may be off.
    static void bound(const RTCBoundsFunctionArguments* arguments) {
        const EmbreePairs& self = *static_cast<EmbreePairs*>(arguments->geometryUserPtr);
        const Aabb& box = self.boxes_[arguments->primID];
        const Real reach = self.sheets_->thickness / 2;
        const auto low = [&](int axis) { return rounded(box.low[axis] - reach, -1); };
        const auto high = [&](int axis) { return rounded(box.high[axis] + reach, 1); };
        RTCBounds& bounds = *arguments->bounds_o;
        bounds.lower_x = low(0), bounds.lower_y = low(1), bounds.lower_z = low(2);
        bounds.upper_x = high(0), bounds.upper_y = high(1), bounds.upper_z = high(2);
    }

    static float rounded(Real value, Real way) {
        return static_cast<float>(value + way * std::abs(value) * Real(std::numeric_limits<float>::epsilon()));
    }

    /// Embree hands on all that two leaves hold, in both orders; the test is the caller's.
    static void collect(void* self, RTCCollision* collisions, unsigned count) {
        const EmbreePairs& method = *static_cast<EmbreePairs*>(self);
        for (unsigned k = 0; k < count; ++k) {
            const unsigned a = collisions[k].primID0, b = collisions[k].primID1;
            if (a >= b || !meet(method.boxes_[a], method.boxes_[b], method.sheets_->thickness)) continue;
            const TrianglePair pair{static_cast<int>(a), static_cast<int>(b)};
            if (!method.sheets_->share_particle(pair.first, pair.second)) method.found_->push_back(pair);
        }
    }

    RTCBuildQuality quality_;
    const Sheets* sheets_ = nullptr;
    RTCDevice device_ = nullptr;
    RTCScene scene_ = nullptr;
    RTCGeometry triangles_ = nullptr;
    std::vector<Aabb> boxes_;
    std::vector<TrianglePair>* found_ = nullptr;
};

}  // namespace

void add_embree_pairs(PairMethods& methods) {
    methods.push_back(std::make_unique<EmbreePairs>("Embree rtcCollide refit", RTC_BUILD_QUALITY_REFIT));
    methods.push_back(std::make_unique<EmbreePairs>("Embree rtcCollide rebuild", RTC_BUILD_QUALITY_LOW));
}

}  // namespace drape::peers
