#include "tour_pictures.h"

#include <memory>

#include "drape/base/progress.h"
#include "drape/base/run_program.h"
#include "drape/render/entries.h"
#include "drape/render/picture_texts.h"
#include "drape/render/renderer.h"
#include "drape/session/tour.h"
#include "drape/sim/simulation.h"
#include "frame_writer.h"
#include "gl_context.h"
#include "picture_memory.h"

namespace drape {

int draw_tour(const CaptureOptions& options, const StopSignals& signals) {
    check_picture_memory(options.size);
    const auto stops = tour_stops();
    FrameWriter pictures(options.out, static_cast<int>(stops.size()), options.again);
    const OffscreenContext context(options.context);
    Renderer renderer;
    renderer.resize(options.size.width, options.size.height);
    Progress progress(stops.size(), "picture");
    int number = 0;
    for (const TourStop& stop : stops) {
        Settings settings = settings_of(stop);
        // A full panel is what the stop is about
        if (!options.overlay && settings.view.panel == PanelSize::Compact) settings.view.panel = PanelSize::Off;
        Simulation simulation(std::string(stop.scene), settings);
        while (simulation.report().time < stop.time && simulation.report().status == Status::Ok) {
            if (signals.arrived() != 0) break;
            simulation.step();
        }
        if (const int signal = signals.arrived()) {
            pictures.finish();
            return 128 + signal;
        }
        if (options.overlay) renderer.set_hint(tour_hint(static_cast<std::size_t>(number)));
        renderer.draw(simulation.view(), Camera(settings.view), {});
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
