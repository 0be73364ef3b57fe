#define PT_KERNEL plain
#include "pt/accel/traverse.h"
