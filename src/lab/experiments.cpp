#include "experiment.h"
#include "precision_experiment.h"
#include "stability_experiment.h"

namespace drape {

const std::vector<Experiment>& experiments() {
    static const std::vector<Experiment> all{stability_experiment(), precision_experiment()};
    return all;
}

}  // namespace drape
