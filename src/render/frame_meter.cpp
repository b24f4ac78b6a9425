#include "frame_meter.h"

namespace drape {

void FrameMeter::count() {
    ++frames_;
    const double elapsed = watch_.seconds();
    const bool over = elapsed >= 1;
    if (!over && !first_second_) return;

    // In the first second, what there is so far
    const double processor = static_cast<double>(std::clock() - processor_start_) / CLOCKS_PER_SEC;
    if (elapsed > 0) {
        rate_ = frames_ / elapsed;
        cpu_ = processor / elapsed;
    }
    if (!over) return;
    first_second_ = false;
    frames_ = 0;
    processor_start_ = std::clock();
    watch_.lap();
}

}  // namespace drape
