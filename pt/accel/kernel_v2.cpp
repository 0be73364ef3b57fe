#define PT_KERNEL v2
#include "pt/accel/traverse.h"
