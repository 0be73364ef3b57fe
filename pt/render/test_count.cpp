#include "pt/render/test_count.h"

namespace pt {

constinit thread_local TestCount test_count;

}  // namespace pt
