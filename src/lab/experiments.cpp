#include "lab/experiments.h"

#include "lab/contact/contact_experiment.h"
#include "lab/hierarchy/hierarchy_experiment.h"
#include "lab/original/original_experiment.h"
#include "lab/precision/precision_experiment.h"
#include "lab/stability/stability_experiment.h"

namespace drape {

std::vector<Experiment> all_experiments() {
    return {stability_experiment(), precision_experiment(), hierarchy_experiment(), contact_experiment(),
            original_experiment()};
}

}  // namespace drape
