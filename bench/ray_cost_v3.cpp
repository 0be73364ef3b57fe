#define PT_KERNEL v3
#include "bench/ray_cost_kernel.h"
