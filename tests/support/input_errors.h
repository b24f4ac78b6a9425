#pragma once

#include <string>

#include "drape/base/input_error.h"

namespace drape::test {

/// The message of the error of a kind that an action throws; empty if it throws none.
template <class Error, class Action>
std::string message_of(Action action) {
    try {
        action();
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

template <class Action>
std::string input_error_of(Action action) {
    return message_of<InputError>(action);
}

template <class Action>
std::string run_error_of(Action action) {
    return message_of<RunError>(action);
}

}  // namespace drape::test
