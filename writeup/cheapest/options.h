#pragma once

#include "pt/scene/frame_camera.h"
#include "pt/scene/tracer.h"

#include <cstdint>
#include <filesystem>

namespace writeup::cheapest {

// The options of the program that finds the cheapest settings.
struct Options {
  std::filesystem::path scene;
  double error = 0.02;  // root of relMSE
  int width = 480;
  int height = 360;
  pt::Framing framing = pt::Framing::course;
  pt::Engine engine = pt::Engine::wide;
  bool lambertian = false;
  double seconds = 45;  // by the wall clock, about
  std::uint64_t seed = 0;
  int threads = 1;
  std::filesystem::path out;  // a folder; empty: no files
};

// Reads the command line. Prints help and exits for --help, throws pt::Error for what it cannot
// use.
Options parse_options(int argc, const char* const* argv);

}  // namespace writeup::cheapest
