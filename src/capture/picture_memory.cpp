#include <algorithm>
#include <string>
#include <thread>

#include "capture.h"
#include "drape/base/input_error.h"
#include "drape/base/memory_limit.h"

namespace drape {

void check_picture_memory(PictureSize size, double scene) {
    // Measured with Mesa 22.3 and LLVM 15: addresses of program, libraries and what they compile, and of the stack and
    // the heap of each thread that draws, of which llvmpipe has at most 32; memory in use; both for a pixel
    constexpr double addresses = 600e6, of_thread = 72e6, most_threads = 32, in_use = 120e6, of_pixel = 60;
    const double threads = std::min(static_cast<double>(std::thread::hardware_concurrency()), most_threads);
    const double pixels = of_pixel * size.width * size.height + scene;
    const auto check = [](double need, double limit, std::string_view whose) {
        if (need <= limit) return;
        throw RunError("out of memory: pictures of this size and scene need about " + bytes_text(need) + ", and " +
                       bytes_text(limit) + " is " + std::string(whose));
    };
    const MemoryLimit limit = memory_limit();
    check(in_use + pixels, limit.bytes, limit.whose);
    if (const auto space = address_space_limit()) {
        check(addresses + threads * of_thread + pixels, *space, "what this process may take (ulimit -v)");
    }
}

}  // namespace drape
