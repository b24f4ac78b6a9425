#include "drape/base/commit.h"
#include "drape/base/numbers.h"
#include "drape/render/image.h"
#include "drape/scene/scene.h"
#include "drape/sim/simulation.h"

namespace drape {

std::vector<ImageText> picture_texts(const Simulation& simulation) {
    return {{"Software", std::string("Drape ") + DRAPE_VERSION},
            {"Commit", commit()},
            {"Scene", simulation.scene()},
            {"Time", real_text(simulation.report().time) + " s"},
            {"Settings", scene_text(simulation.settings())}};
}

}  // namespace drape
