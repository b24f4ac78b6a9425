#include "experiment.h"
#include "stability_experiment.h"

namespace drape {

const std::vector<Experiment>& experiments() {
    static const std::vector<Experiment> all{stability_experiment()};
    return all;
}

}  // namespace drape
