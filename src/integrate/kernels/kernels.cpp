// The kernels of a layer, in one file because Highway reads it once a kind of processor, with all that it includes.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "integrate/kernels/kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "integrate/kernels/spring_pass_kernels-inl.h"
#include "integrate/kernels/stencil_kernels-inl.h"
