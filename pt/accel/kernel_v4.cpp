#define PT_KERNEL v4
#include "pt/accel/traverse.h"
