#pragma once

#include "pt/render/render_film.h"
#include "view/worker/settings.h"

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

namespace view {

// A picture that gets better for as long as it is asked for: first coarse normals, then coarse light, then samples of every
// pixel, in passes of more and more.
struct Picture {
  Settings settings;
  pt::View view;
  int stage = 0;  // 0, 1: coarse; from 2 on: passes over all pixels
  int next_pixel =
      0;  // of the stage; 0: the stage before it is finished, and nothing of this one is shown
  long long samples = 0;  // per pixel, in the passes that are complete
  double seconds = 0;
  pt::RayCount rays{};
  long long not_finite = 0;
  std::string note{};               // why nothing can be seen
  std::vector<pt::BadPixel> bad{};  // the first pixels with samples that were not finite
  std::vector<float>
      shown{};  // r, g, b of each pixel, the top row first; false colours: a number, three times

  struct Sum {
    pt::Rgb mean;
    double squares = 0;  // sum of the squared differences of the luminance from its mean
    double counted = 0;  // boxes or primitives that were tested, or points of paths
    long long samples = 0;
    int stage = 0;
  };
  std::vector<Sum> sums{};
};

Picture begin_picture(const pt::LoadedScene& loaded, const Settings& settings);

// Goes on for about this time, with the threads of the settings. Returns false if there is nothing left to do.
bool improve(Picture& picture, std::chrono::milliseconds time);

}  // namespace view
