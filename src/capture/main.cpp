#include "capture.h"
#include "capture_options.h"
#include "drape/base/program.h"

namespace drape {
namespace {

int run(int argc, char** argv) {
    auto options = read_capture_options(argc, argv);
    return options ? Capture(std::move(*options)).run() : Done;
}

}  // namespace
}  // namespace drape

int main(int argc, char** argv) { return drape::run_program("drape-capture", argc, argv, drape::run); }
