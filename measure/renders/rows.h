#pragma once

#include "pt/render/render_rows.h"
#include "pt/scene/scene.h"

#include <cstdint>
#include <string>
#include <vector>

// Pixels and what they cost, for renders and for measurements of scenes. There are two implementations, and a program links
// one of them:
//   here   (rows_here.cpp), by the tasks linked into this program;
//   boxed  (boxed.cpp), by the worker of a submission, in its box: by one thread.

namespace measure {

struct CostedRows {
  pt::PictureRows rows;
  double cpu_seconds = 0;
  std::int64_t rays = 0;
};
CostedRows costed_rows(const pt::View& view, const pt::RowsRequest& request);

// A request of about this many seconds costs little besides its pixels.
extern const double kQuick;

// Gives the scene of the view its tracer. Its engine is linear if the tasks of the tree are not written yet.
void give_tracer(pt::Scene& scene, const pt::View& view, pt::Engine engine);

// The tasks that were called so far but are not written yet, in alphabetical order.
std::vector<std::string> unwritten_tasks();

// Of this thread, so far.
inline std::int64_t rays_so_far() { return pt::rays_traced().closest + pt::rays_traced().occluded; }

}  // namespace measure
