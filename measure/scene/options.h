#pragma once

#include "pt/scene/frame_camera.h"
#include "pt/scene/load_collada.h"
#include "pt/scene/tracer.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace measure::scene {

// The options of three programs: `cheapest` finds settings, `converge` compares methods, `ladder`
// measures the worth of ideas.
struct Options {
  std::filesystem::path scene;
  double error = 0.02;  // for cheapest: root of relMSE
  int bounces = 5;      // for converge and ladder
  int samples = 64;     // for ladder: per pixel
  int width = 480;
  int height = 360;
  pt::Framing framing = pt::Framing::course;
  pt::Engine engine = pt::Engine::wide;
  bool lambertian = false;
  double seconds = 45;  // approximate, by the wall clock
  std::uint64_t seed = 0;
  int threads = 1;
  std::filesystem::path out;  // a folder; empty: no files
  std::string beside;         // for converge: the method to compare with; empty: the fastest
  // Somebody else's code, in the box; empty: what is linked here. `converge` compares several.
  std::vector<std::string> submissions;
  std::vector<std::string> built;  // the same, already built: the files with the details
  std::vector<std::string> names;  // of those, for captions and files
  std::string whose;               // in captions: the code that is measured now
  std::string prefix;              // of the names of files, where several are compared
  bool reference =
      false;  // errors are measured against the reference, whose program is beside this one
  // Right pictures to measure errors against in its place: one, or two with other random numbers.
  std::vector<std::string> goldens;
  int pixels = 10000;                          // the approximate number of pixels to measure
  std::vector<int> light_samples{1, 2, 4, 8};  // for cheapest: tried for the lines; rising
};

// "box.dae by anna, 480 x 360 pixels": the beginning of captions and, in two lines, of charts.
std::string subject_of(const Options& options, const char* between = ", ");

// The title of a chart: the subject, and the settings in a line below. For gnuplot.
std::string title_of(const Options& options, const std::string& settings);

// Of all captions.
inline constexpr const char* kErrorCaption =
    "Errors are the root of relMSE: the mean over the pixels of (x - g)^2 / (g + d)^2, where g is "
    "the picture without noise "
    "and d 4 % of its mean.";

// The caption of a chart. `machine` is empty where the chart has no times.
std::string caption_of(const Options& options, const std::string& what, const std::string& settings,
                       const std::string& machine);

enum class Command { cheapest, converge };

struct Call {
  Command command = Command::cheapest;
  Options options;
  std::string program;  // this one
};

// Reads the command line, whose first word is the command. Prints help and exits for --help; throws
// pt::Error for unusable options.
Call parse_call(int argc, const char* const* argv);
// Reads the options of one command, without that word.
Options parse_cheapest(int argc, const char* const* argv);
Options parse_converge(int argc, const char* const* argv);
Options parse_ladder(int argc, const char* const* argv);

inline constexpr int kMaxLeaf = 4;  // as in ./run render

// The scene, ready to be traced. Makes the folder of --out. Throws pt::Error, one sentence, if the
// scene cannot be measured.
pt::LoadedScene load_scene(const Options& options);

// Prints the loader's notes to standard error.
void print_notes(const pt::LoadedScene& loaded);

}  // namespace measure::scene
