#include "pt/tasks/direct_lights.h"
#include "writeup/measure/rooms.h"

namespace writeup::measure {

Subject measure_direct_lights(int of_case) { return measure_direct(pt::direct_lights, of_case); }

}  // namespace writeup::measure
