#include <sstream>

#include "drape/base/numbers.h"
#include "drape/sim/comparison.h"
#include "drape/sim/tour.h"

namespace drape {

namespace {

constexpr std::string_view introduction = R"(# Tour

Twelve scenes, with what to see in each, what to try, and which file explains it. In the window, F1 begins the tour, as
does `build/release/bin/drape --tour`, and everything can be touched on the way. Under each picture is the command that
shows its scene, and the time at which the picture was taken.

Made by `build/release/bin/drape-lab list tour > docs/tour.md`, and the pictures by

```
build/release/bin/drape-capture --tour --size 840x473 --out docs/tour --again
```
)";

std::string picture_name(std::size_t number) {
    const std::string digits = std::to_string(number);
    return "tour/frame_" + std::string(4 - digits.size(), '0') + digits + ".png";
}

}  // namespace

std::string tour_page() {
    std::ostringstream page;
    page << introduction;
    std::size_t number = 0;
    for (const TourStop& stop : tour_stops()) {
        page << "\n## " << ++number << " " << stop.title << "\n\n";
        page << "![" << stop.title << "](" << picture_name(number) << ")\n\n";
        page << "`build/release/bin/drape " << stop.scene;
        for (const std::string& change : split_assignments(stop.changes)) page << " --set " << change;
        page << "`, at " << real_text(stop.time) << " s\n\n";
        page << "See: " << stop.look << "\n\nTry: " << stop.try_it << "\n\n";
        page << "Read: [" << stop.file << "](../" << stop.file << ")\n";
    }
    return page.str();
}

}  // namespace drape
