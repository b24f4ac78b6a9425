#include "lab/contact/contact_experiment.h"
#include "lab/experiment/experiment.h"
#include "lab/hierarchy/hierarchy_experiment.h"
#include "lab/original/original_experiment.h"
#include "lab/precision/precision_experiment.h"
#include "lab/stability/stability_experiment.h"

namespace drape {

const std::vector<Experiment>& experiments() {
    static const std::vector<Experiment> all{stability_experiment(), precision_experiment(), hierarchy_experiment(),
                                             contact_experiment(), original_experiment()};
    return all;
}

}  // namespace drape
