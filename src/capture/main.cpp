#include "capture.h"
#include "drape/base/run_program.h"

namespace drape {
namespace {

int run(int argc, char** argv) {
    auto options = read_capture_options(argc, argv);
    if (!options) return Done;
    const StopSignals signals;
    if (options->tour) return draw_tour(*options, signals);
    return capture(std::move(*options), signals);
}

}  // namespace
}  // namespace drape

int main(int argc, char** argv) { return drape::run_program("drape-capture", argc, argv, drape::run); }
