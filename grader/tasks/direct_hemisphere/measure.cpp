#include "pt/tasks/direct_hemisphere.h"
#include "writeup/measure/rooms.h"

namespace writeup::measure {

Subject measure_direct_hemisphere(int of_case) {
  return measure_direct(pt::direct_hemisphere, of_case);
}

}  // namespace writeup::measure
