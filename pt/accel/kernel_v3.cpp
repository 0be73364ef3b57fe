#define PT_KERNEL v3
#include "pt/accel/traverse.h"
