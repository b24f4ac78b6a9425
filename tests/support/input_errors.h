#pragma once

#include <string>

#include "drape/base/input_error.h"

namespace drape::test {

/// The message of the InputError that an action throws; empty if it throws none.
template <class Action>
std::string input_error_of(Action action) {
    try {
        action();
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

}  // namespace drape::test
