// writeup_boxed: makes a submission's pictures without running its code in this process.
//   writeup_boxed build SUBMISSION OUT.json       compiles it in the box and links a worker
//   writeup_boxed build SUBMISSION OUT.json PARTS.json [TASK ...]   the same with other parts, and only these tasks of it
//   writeup_boxed render WORKER TIER SPEC BAND    renders some rows with that worker
#include "grader/service/process/spawn.h"
#include "grader/service/wire/session.h"
#include "grader/service/wire/worker_rows.h"
#include "measure/renders/band.h"
#include "measure/renders/boxed.h"
#include "pt/end_of_program.h"
#include "pt/error.h"
#include "pt/render/choose_engine.h"
#include "pt/render/darkness.h"
#include "pt/scene/frame_camera.h"
#include "pt/scene/load_collada.h"

#include <algorithm>
#include <csignal>
#include <cstdio>

namespace measure {
namespace {

using namespace grader;
using Words = std::vector<std::string>;

constexpr int kChunk = 6;                      // rows of the first request
constexpr std::chrono::minutes kCallLimit{5};  // the write-up's own limit is usually shorter
constexpr double kQuick = 0.1;  // seconds: after a faster answer, requests get larger

RowPixel row_pixel(const Spec& spec, const pt::PictureRows& answer, std::size_t i) {
  const pt::Rgb mean = is_finite(answer.mean[i]) ? answer.mean[i] : pt::Rgb{};
  const auto value = [&](const std::vector<double>& values) {
    return values.empty() ? -1.F : static_cast<float>(values[i]);
  };
  const int samples = answer.counts.empty() ? spec.samples : answer.counts[i];
  return {{static_cast<float>(mean.r), static_cast<float>(mean.g), static_cast<float>(mean.b)},
          samples < 2 ? -1 : value(answer.measured.variance_y),
          samples,
          value(answer.measured.boxes)};
}

// A row of the file for each row of the answer. The sums are divided among the rows.
void append(const Band& band, const Spec& spec, const pt::PictureRows& answer, int rows,
            const RowHead& total) {
  for (int y = 0; y < rows; ++y) {
    const auto share = [&](std::int64_t all) { return all * (y + 1) / rows - all * y / rows; };
    Row row;
    row.head = {total.cpu_seconds / rows, share(total.rays),    share(total.boxes),
                share(total.triangles),   share(total.spheres), share(total.not_finite)};
    for (int x = 0; x < spec.row_pixels(); ++x) {
      row.pixels.push_back(
          row_pixel(spec, answer, static_cast<std::size_t>(y) * spec.row_pixels() + x));
    }
    append_row(band.file(), row);
  }
}

std::int64_t rays() { return pt::rays_traced().closest + pt::rays_traced().occluded; }

// The worker renders some rows into the band's file. Returns their seconds.
double make_rows(const pt::View& view, const Spec& spec, const Band& band, int y, int rows) {
  const double before = worker_seconds();
  const std::int64_t rays_before = rays();
  const pt::PictureRows answer =
      wire::worker_rows(view, {y, rows, spec.samples, spec.adaptive, spec.seed, spec.ranges});
  const pt::RowsMeasured& measured = answer.measured;
  if (!measured.apart) {
    throw pt::Error(std::string(kRangesNotApart) +
                    ": they do not add up to what trace_path returned");
  }
  const double seconds = worker_seconds() - before;
  append(band, spec, answer, rows,
         {seconds, rays() - rays_before, measured.tests.boxes, measured.tests.triangles,
          measured.tests.spheres, measured.not_finite});
  return seconds;
}

bool tree_is_missing() {
  const auto& todo = wire::session().record().todo;
  return std::ranges::any_of(
      pt::kTreeTasks, [&](std::string_view task) { return todo.contains(std::string(task)); });
}

std::vector<std::string> missing_tasks(const Spec& spec, bool tree_missing) {
  std::vector<std::string> missing;
  for (const std::string& task : tasks_used(spec)) {
    const bool of_tree = std::ranges::count(pt::kTreeTasks, task) > 0;
    if (of_tree && tree_missing) continue;
    if (wire::session().record().todo.contains(task)) missing.push_back(task);
  }
  return missing;
}

int render(const std::string& worker, const std::string& tier, const std::string& spec_file,
           const Band& band) {
  const Spec spec = read_spec(spec_file);
  pt::LoadedScene loaded = pt::load_collada(spec.scene);
  if (!spec.path.show_normals) require_light(loaded, spec.scene);
  // With this engine the worker builds its own tree.
  loaded.scene.tracer = pt::Tracer(spec.engine, loaded.scene.primitives);
  const pt::View view{loaded.scene,
                      frame_camera(loaded, spec.framing, spec.frame_width, spec.frame_height),
                      spec.path, spec.width, spec.height};
  open_worker(worker, tier, kCallLimit);
  // One row shows whether there is a tree.
  wire::worker_rows(view, {band.first_row, 1, 1, {}, spec.seed, {}});
  const bool without_tree = spec.engine == pt::Engine::task && tree_is_missing();
  if (without_tree) loaded.scene.tracer = pt::Tracer(pt::Engine::linear, loaded.scene.primitives);
  const int end = band.first_row + band.rows;
  int rows = kChunk;
  for (int y = start_band(band, spec.row_pixels()); y < end;) {
    const int now = std::min(rows, end - y);
    if (make_rows(view, spec, band, y, now) < kQuick) rows *= 2;
    y += now;
  }
  const std::string engine(pt::name(loaded.scene.tracer.engine()));
  finish_band(band, {missing_tasks(spec, without_tree), engine, loaded.scene.primitives.size()});
  return 0;
}

int run(const Words& words) {
  if (words.size() == 3 && words[0] == "build") {
    write_boxed(build_submission(words[1]), words[2]);
    return 0;
  }
  if (words.size() > 3 && words[0] == "build") {
    write_boxed(build_submission(words[1], words[3], {words.begin() + 4, words.end()}), words[2]);
    return 0;
  }
  if (words.size() == 5 && words[0] == "render") {
    return render(words[1], words[2], words[3], band_of(words[4]));
  }
  throw pt::Error("writeup_boxed build SUBMISSION OUT.json | render WORKER TIER SPEC BAND");
}

}  // namespace
}  // namespace measure

int main(int argc, char** argv) {
  grader::process::hide_process();
  std::signal(SIGPIPE, SIG_IGN);
  return pt::run_program([&] { return measure::run({argv + 1, argv + argc}); });
}
