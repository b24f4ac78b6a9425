#pragma once

#include <string>
#include <vector>

#include "drape/render/image.h"
#include "drape/sim/frame_view.h"

namespace drape::test {

/// Compares a picture with what the state means: where the cloth's front and back are, where the ball's outline runs,
/// that the light falls on the ground and that cloth and ball keep it off.
/// @return what is wrong, one word first: "cloth", "front", "back", "ball", "light", "shadow"
std::vector<std::string> complaints(const Image& image, const FrameView& truth);

}  // namespace drape::test
