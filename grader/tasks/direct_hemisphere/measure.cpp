#include "measure/calls/rooms.h"
#include "pt/tasks/direct_hemisphere.h"

namespace measure::calls {

Subject measure_direct_hemisphere(int of_case) {
  return measure_direct(pt::direct_hemisphere, of_case);
}

}  // namespace measure::calls
