#define PT_KERNEL plain
#include "bench/ray_cost_kernel.h"
