#pragma once

#include "drape/render/image.h"

namespace drape {

/// To be called before there is a context: a drawing library that finds too little memory ends the whole program.
/// @param scene what a simulation takes on top [bytes]
/// @throws RunError that says what pictures need, where this machine, the process's control group or `ulimit -v` allows
///         less
void check_picture_memory(PictureSize size, double scene = 0);

}  // namespace drape
