// Sleeps in every call, a little less than a call may in this test, and crashes then: no process stays of which the kernel could
// tell what it did.
#include "pt/tasks/hit_sphere.h"

#include <cstdlib>
#include <ctime>

namespace pt {

std::optional<SurfaceHit> hit_sphere(const Sphere&, const Ray&) {
  const timespec time{0, 200'000'000};
  nanosleep(&time, nullptr);
  std::abort();
}

}  // namespace pt
