#pragma once

#include <vector>

#include "drape/contact/warm_start.h"
#include "drape/model/cloth_model.h"
#include "drape/sim/cloth_energy.h"
#include "drape/sim/cloth_integrator.h"
#include "drape/sim/contact_search.h"

namespace drape {

/// A cloth with all that its steps need.
struct Cloth {
    ClothModel model;
    ClothState state;
    ClothState previous;  ///< one step before `state`
    Points before;        ///< positions one substep before, where steps are divided
    ClothIntegrator integrator;
    ContactSearch search;
    std::vector<Contact> contacts;        ///< of the last step that was awake
    std::vector<Contact> first_contacts;  ///< keeps these during a second look
    WarmStart<Contact> warm_start;
    ClothEnergy energy;
    int held = -1;       ///< particle that the hand leads; below 0: none
    Real pin_speed = 0;  ///< of the fastest pin that `MovingPins` leads [m/s]
};

}  // namespace drape
