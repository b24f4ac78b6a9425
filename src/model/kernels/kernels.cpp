// The kernels of a layer, in one file because Highway reads it once a kind of processor, with all that it includes.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/kernels/kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "model/kernels/energy_kernels-inl.h"
#include "model/kernels/force_kernels-inl.h"
#include "model/kernels/jacobian_kernels-inl.h"
#include "model/kernels/wind_kernels-inl.h"
