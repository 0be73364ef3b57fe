#include "measure/renders/rows.h"
#include "pt/render/choose_engine.h"
#include "pt/render/cpu_time.h"
#include "pt/todo_list.h"

namespace measure {

namespace {

constexpr int kMaxLeaf = 4;  // as in ./run render

}  // namespace

const double kQuick = 0.01;

CostedRows costed_rows(const pt::View& view, const pt::RowsRequest& request) {
  const double start = pt::thread_cpu_seconds();
  const std::int64_t before = rays_so_far();
  pt::PictureRows rows = pt::render_rows(view, request);
  return {std::move(rows), pt::thread_cpu_seconds() - start, rays_so_far() - before};
}

void give_tracer(pt::Scene& scene, const pt::View&, pt::Engine engine) {
  choose_engine(scene, engine, kMaxLeaf);
}

std::vector<std::string> unwritten_tasks() { return pt::todo_list(); }

}  // namespace measure
