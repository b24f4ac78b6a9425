#pragma once

#include <string>
#include <vector>

#include "capture/gl_context.h"
#include "drape/render/renderer.h"
#include "drape/scene/scene.h"
#include "drape/scene/setting_table.h"
#include "drape/sim/simulation.h"

namespace drape::test {

/// The picture of a view, by a new renderer.
inline Image picture_of(const FrameView& view, int width, int height, const ViewSettings& from,
                        ContextKind kind = ContextKind::Auto) {
    const GlContext context = make_context(kind);
    Renderer renderer;
    renderer.resize(width, height);
    renderer.draw(view, Camera(from), {});
    return renderer.read_back();
}

inline Image picture_of(const FrameView& view, int width, int height) {
    return picture_of(view, width, height, view.settings->view);
}

/// Of a pixel, up to 765.
inline double brightness_at(const Image& image, int x, int y) {
    const std::uint8_t* p = image.pixel(x, y);
    return p[0] + p[1] + p[2];
}

/// A scene with some settings changed.
inline Settings changed_scene(const std::string& scene, const std::vector<std::string>& changes) {
    Settings settings = load_scene(scene);
    for (const std::string& change : changes) assign(settings, change);
    return settings;
}

/// A scene at a time of it, without the panel of figures, and a view of it with settings that may be changed.
struct DrawnScene {
    explicit DrawnScene(const std::string& scene, double time = 0, const std::vector<std::string>& changes = {})
        : simulation(scene, changed_scene(scene, changes)) {
        while (simulation.report().time < time) simulation.step();
        view = simulation.view();
        settings = *view.settings;
        settings.view.panel = PanelSize::Off;
        view.settings = &settings;
    }
    DrawnScene(const DrawnScene&) = delete;
    DrawnScene& operator=(const DrawnScene&) = delete;

    [[nodiscard]] const ClothView& cloth() const { return view.cloths[0]; }

    Simulation simulation;
    Settings settings;
    FrameView view;
};

}  // namespace drape::test
