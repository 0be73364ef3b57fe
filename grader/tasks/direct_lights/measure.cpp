#include "measure/calls/rooms.h"
#include "pt/tasks/direct_lights.h"

namespace measure::calls {

Subject measure_direct_lights(int of_case) { return measure_direct(pt::direct_lights, of_case); }

}  // namespace measure::calls
