#include "picture_pace.h"

namespace drape {

void PicturePace::drew(bool fast, double seconds) {
    drawn_fast_ = fast;
    if (fast != slow_) return;  // a full picture of what stands still says nothing of a display known as slow
    const bool speaks_for_change = slow_ ? seconds < shortest : seconds > longest;
    in_a_row_ = speaks_for_change ? in_a_row_ + 1 : 0;
    row_time_ = speaks_for_change ? row_time_ + seconds : 0;
    const bool changes = slow_ ? in_a_row_ >= wanted_quick_ : in_a_row_ >= min_slow && row_time_ >= max_lost;
    if (!changes) return;
    slow_ = !slow_;
    if (!slow_) wanted_quick_ *= 2;
    in_a_row_ = 0;
    row_time_ = 0;
}

}  // namespace drape
