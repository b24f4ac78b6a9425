#pragma once

#include "drape/contact/contact_activity.h"
#include "drape/contact/contact_rows.h"

namespace drape {

/// Working memory of the contact solves that are faster than plain code, kept from one response to the next.
struct FastSolve {
    ContactRows rows;          ///< without pairs, and where nothing pushes a ball: with the bits of the plain solve
    ContactActivity activity;  ///< with pairs: ends by the test of the plain solve, with other bits

    /// Forgets the contacts.
    void clear() {
        rows.clear();
        activity.clear();
    }
};

}  // namespace drape
