#pragma once

namespace pt {

// The light that radiance() adds up along one ray.
struct PathSettings {
  enum class Direct { hemisphere, lights };  // the estimator of direct light

  int light_samples = 1;  // directions for `hemisphere`; samples per area light for `lights`
  Direct direct = Direct::lights;
  double survival = 0.7;  // the probability that a path goes on, in (0, 1]

  // The bounces to add up, both included. 0 is emitted light that reaches the camera directly, 1 is
  // direct light, 2 and more are indirect light. Full: 0 .. m; direct only: 1 .. 1; indirect only:
  // 2 .. m; one bounce: k .. k.
  int from = 0;
  int to = 1;

  bool show_normals = false;  // no light: the colour is the normal, as (n + 1) / 2
};

}  // namespace pt
