#define PT_KERNEL v4
#include "bench/ray_cost_kernel.h"
