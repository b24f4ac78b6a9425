#include <memory>

#include "capture.h"
#include "drape/base/progress.h"
#include "drape/base/run_program.h"
#include "drape/render/entries.h"
#include "drape/render/renderer.h"
#include "drape/scene/scene.h"
#include "drape/session/session.h"
#include "drape/session/tour.h"
#include "frame_writer.h"
#include "gl_context.h"

namespace drape {

int draw_tour(const CaptureOptions& options, const StopSignals& signals) {
    check_picture_memory(options.size);
    const auto stops = tour_stops();
    FrameWriter pictures(options.out, static_cast<int>(stops.size()), options.again);
    const GlContext context = make_context(options.context);
    Renderer renderer;
    renderer.resize(options.size.width, options.size.height);
    Progress progress(stops.size(), "picture");
    int number = 0;
    for (const TourStop& stop : stops) {
        Session session(Simulation(std::string(stop.scene), load_scene(std::string(stop.scene))));
        for (const Command& command : commands_of(stop)) session.send(command);
        Simulation& simulation = session.simulation();
        const ViewSettings& shown = simulation.settings().view;
        // What is slow or has spheres says so in its panel; a full one is what the stop is about
        const bool needs_panel = shown.panel == PanelSize::Full || shown.speed != 1 || shown.bounds;
        if (!options.overlay && !needs_panel) session.send(command::Set{"view.panel=off"});
        if (options.overlay) renderer.panels().hint = tour_hint(static_cast<std::size_t>(number));
        // Panels show medians and curves of what was drawn since the scene began
        constexpr int views = 6;
        for (int k = 0; k <= views; ++k) {
            session.run_until(stop.time * k / views, [&] { return signals.arrived() != 0; });
            if (const int signal = signals.arrived()) {
                pictures.finish();
                return 128 + signal;
            }
            renderer.draw(session.view(), Camera(shown), {});
        }
        const auto image = std::make_shared<Image>(renderer.read_back());
        image->texts = picture_texts(simulation);
        pictures.write(image, ++number);
        progress.advance();
    }
    pictures.finish();
    progress.close(options.out);
    pictures.remove_older();
    return Done;
}

}  // namespace drape
