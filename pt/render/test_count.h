#pragma once

namespace pt {

// Numbers of boxes and primitives that this thread has tested since it started, in programs that
// link the counted implementations of hit_box, hit_triangle and hit_sphere (cmake/counted.cpp.in).
// In programs that link the plain ones they stay zero, and counting costs nothing.
struct TestCount {
  long long boxes = 0;
  long long triangles = 0;
  long long spheres = 0;
};

extern constinit thread_local TestCount test_count;

}  // namespace pt
