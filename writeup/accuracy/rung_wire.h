#pragma once

#include "pt/render/render_film.h"
#include "writeup/accuracy/options.h"

#include <string>
#include <vector>

// The messages between `ladder` and the programs of its rungs: a line each.

namespace writeup::accuracy {

// Some of the pixels of the picture, rendered once: `first`, and each `step`-th after it, of
// spread_pixels() by the options that both were started with.
struct RungRequest {
  pt::PathSettings path;
  pt::RenderSettings render;
  std::size_t first = 0;
  std::size_t step = 1;
};

struct RungReply {
  double cpu_seconds = 0;    // of all threads
  long long rays = 0;        // of all pixels
  long long samples = 0;     // of all pixels
  std::vector<double> mean;  // of each pixel, luminance
};

// Without the end of the line. The readers throw pt::Error for what these did not write.
std::string to_line(const RungRequest& request);
std::string to_line(const RungReply& reply);
RungRequest request_from(const std::string& line);
RungReply reply_from(const std::string& line);

// The words of the command line that give a rung's program these options.
std::vector<std::string> words_of(const Options& options);

}  // namespace writeup::accuracy
