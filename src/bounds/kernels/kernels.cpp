// The kernels of a layer, in one file because Highway reads it once a kind of processor, with all that it includes.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "bounds/kernels/kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "bounds/kernels/patch_kernels-inl.h"
