#pragma once

#include "pt/scene/frame_camera.h"
#include "pt/scene/tracer.h"

#include <cstdint>
#include <filesystem>

namespace writeup::accuracy {

// The options of three programs: `cheapest` finds settings, `converge` compares methods, `ladder` tells
// what an idea is worth.
struct Options {
  std::filesystem::path scene;
  double error = 0.02;  // of cheapest: root of relMSE
  int bounces = 5;      // of converge and ladder
  int samples = 64;     // of ladder: per pixel
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

// They read the command line, print help and exit for --help, and throw pt::Error for what they cannot
// use.
Options parse_cheapest(int argc, const char* const* argv);
Options parse_converge(int argc, const char* const* argv);
Options parse_ladder(int argc, const char* const* argv);

}  // namespace writeup::accuracy
