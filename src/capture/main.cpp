#include "capture.h"
#include "capture_options.h"
#include "drape/base/run_program.h"
#include "tour_pictures.h"

namespace drape {
namespace {

int run(int argc, char** argv) {
    auto options = read_capture_options(argc, argv);
    if (!options) return Done;
    const StopSignals signals;
    if (options->tour) return draw_tour(*options, signals);
    return Capture(std::move(*options), signals).run();
}

}  // namespace
}  // namespace drape

int main(int argc, char** argv) { return drape::run_program("drape-capture", argc, argv, drape::run); }
