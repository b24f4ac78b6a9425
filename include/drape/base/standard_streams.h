#pragma once

namespace drape {

/// Takes the places of standard input, output and error that were closed at the start: the next files to be opened
/// would get them, and whatever is printed would go into those. What is written there fails, as it did.
void keep_standard_streams_apart();

}  // namespace drape
