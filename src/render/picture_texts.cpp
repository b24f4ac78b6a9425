#include "drape/render/picture_texts.h"

#include "drape/base/commit.h"
#include "drape/base/numbers.h"
#include "drape/scene/scene.h"

namespace drape {

std::vector<ImageText> picture_texts(const Simulation& simulation) {
    return {{"Software", std::string("Drape ") + DRAPE_VERSION},
            {"Commit", commit()},
            {"Scene", simulation.scene()},
            {"Time", real_text(simulation.report().time) + " s"},
            {"Settings", scene_text(simulation.settings())}};
}

}  // namespace drape
