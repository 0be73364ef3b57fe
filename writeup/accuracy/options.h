#pragma once

#include "pt/scene/frame_camera.h"
#include "pt/scene/tracer.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

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
  std::string beside;      // of converge: the method that all are compared with; empty: the fastest
  std::string submission;  // somebody else's code, in the box; empty: what is linked here
  std::string built;       // the same, built already: the file that says how; then its worker
  std::filesystem::path keep;  // a folder for what a stopped run had measured; empty: none
  int pixels = 10000;          // that are looked at, about
  std::vector<int> light_samples{1, 2, 4, 8};  // of cheapest: tried for the two lines; rising
};

enum class Command { cheapest, converge };

struct Call {
  Command command = Command::cheapest;
  Options options;
};

// Reads the command line, whose first word is the command. Prints help and exits for --help; throws
// pt::Error for what it cannot use.
Call parse_call(int argc, const char* const* argv);
// The same of one command, without that word.
Options parse_cheapest(int argc, const char* const* argv);
Options parse_converge(int argc, const char* const* argv);
Options parse_ladder(int argc, const char* const* argv);

}  // namespace writeup::accuracy
