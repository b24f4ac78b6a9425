#include "lab/experiments.h"

namespace drape {

std::vector<Experiment> all_experiments() {
    return {stability_experiment(),    precision_experiment(), hierarchy_experiment(), contact_experiment(),
            self_contact_experiment(), original_experiment(),  kernels_experiment(),   continuous_experiment(),
            combinations_experiment(), responses_experiment(), rest_experiment()};
}

}  // namespace drape
