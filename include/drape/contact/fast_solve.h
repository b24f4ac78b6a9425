#pragma once

#include "drape/contact/contact_activity.h"
#include "drape/contact/contact_rows.h"

namespace drape {

/// What solves of contacts that are faster than plain code work with, kept from one response to the next.
struct FastSolve {
    ContactRows rows;          ///< without pairs, and where nothing pushes a ball: the same bits
    ContactActivity activity;  ///< with pairs: the same, up to the tolerance

    /// Forgets the contacts.
    void clear() {
        rows.clear();
        activity.clear();
    }
};

}  // namespace drape
