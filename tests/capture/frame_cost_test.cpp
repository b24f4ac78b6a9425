// What one frame after another asks of a graphics card: a single upload, no object or store that is new, and nothing
// that would wait for the card. So the frame of a window is bound by the display.

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string_view>

#include "bench/drawing/silent_context.h"
#include "drawn_scene.h"
#include "support/allocations.h"

namespace drape::test {
namespace {

int uploads = 0, stops = 0;

long count_upload() { return ++uploads, 0; }
long count_stop() { return ++stops, 0; }

/// Does nothing, and counts what it is asked for.
GlContext::Function counting_function(const char* name) {
    static const std::set<std::string_view> of_uploads{"glBufferData", "glBufferSubData", "glTexSubImage2D"};
    static constexpr const char* starts_of_stops[] = {
        "glGen",         "glCreate",      "glMap",        "glTexImage", "glRenderbufferStorage",
        "glGetTexImage", "glLinkProgram", "glReadPixels", "glFinish",   "glClientWaitSync"};
    if (of_uploads.contains(name)) return reinterpret_cast<GlContext::Function>(count_upload);
    const auto begins = [&](const char* start) { return std::string_view(name).starts_with(start); };
    if (std::ranges::any_of(starts_of_stops, begins)) return reinterpret_cast<GlContext::Function>(count_stop);
    return silent_function(name);
}

TEST(FrameCost, IsOneUploadAndNothingThatIsNewOrWaits) {
    uploads = stops = 0;
    load_gl_functions({{}, counting_function});
    DrawnScene scene("drop", 0, {"view.bounds=true", "view.contacts=true", "view.particles=true", "view.plots=true"});
    scene.settings.view.panel = PanelSize::Full;
    scene.settings.view.controls = true;
    Renderer renderer;
    renderer.panels().set_scene(scene.settings);
    renderer.resize(1280, 720);
    EXPECT_GT(uploads, 1);
    EXPECT_GT(stops, 20) << "what it is made of";
    Camera camera(scene.settings.view);
    for (int frame = 0; frame < 90; ++frame) {
        for (int step = 0; step < 10; ++step) scene.simulation.step();
        FrameView view = scene.simulation.view();
        view.settings = &scene.settings;
        camera.apply(command::Orbit{0.01, 0}, view);
        if (frame == 30) uploads = stops = 0;  // until then plots fill, and what is seen grows
        const long long before = allocations();
        renderer.draw(view, camera, {});
        renderer.present(false);
        EXPECT_LE(allocations() - before, frame < 30 ? 5000 : 600) << "texts of the open panels: about 400";
    }
    EXPECT_EQ(uploads, 60);
    EXPECT_EQ(stops, 0);
}

}  // namespace
}  // namespace drape::test
