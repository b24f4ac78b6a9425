#include "contact_experiment.h"
#include "experiment.h"
#include "hierarchy_experiment.h"
#include "original_experiment.h"
#include "precision_experiment.h"
#include "stability_experiment.h"

namespace drape {

const std::vector<Experiment>& experiments() {
    static const std::vector<Experiment> all{stability_experiment(), precision_experiment(), hierarchy_experiment(),
                                             contact_experiment(), original_experiment()};
    return all;
}

}  // namespace drape
