// writeup_render SPEC.json BAND: renders some rows of one render, and goes on where the band's file
// ends. It is a separate program, so that a crash or an endless loop in a learner's code ends
// nothing else.
#include "measure/renders/band.h"
#include "pt/end_of_program.h"
#include "pt/error.h"
#include "pt/file.h"
#include "pt/render/choose_engine.h"
#include "pt/render/cpu_time.h"
#include "pt/render/darkness.h"
#include "pt/render/render_apart.h"
#include "pt/render/render_film.h"
#include "pt/scene/frame_camera.h"
#include "pt/scene/load_collada.h"
#include "pt/scene/recorder.h"
#include "pt/todo.h"

#include <algorithm>
#include <cstdio>

namespace measure {
namespace {

constexpr int kMaxLeaf = 4;  // as in ./run render

std::int64_t rays() { return pt::rays_traced().closest + pt::rays_traced().occluded; }

RowPixel row_pixel(const pt::FilmPixel& pixel, long long boxes) {
  return {{static_cast<float>(pixel.mean.r), static_cast<float>(pixel.mean.g),
           static_cast<float>(pixel.mean.b)},
          pixel.samples < 2 ? -1 : static_cast<float>(pixel.variance_y),
          pixel.samples,
          static_cast<float>(boxes)};
}

void render_pixels(const pt::View& view, int y, const pt::RenderSettings& settings, Row& row) {
  for (int x = 0; x < view.width; ++x) {
    const long long boxes = pt::recorder.count.boxes;
    const pt::RenderedPixel rendered = render_pixel(view, x, y, settings);
    row.head.not_finite += rendered.not_finite;
    row.pixels.push_back(row_pixel(rendered.pixel, pt::recorder.count.boxes - boxes));
  }
}

void render_ranges(const pt::View& view, int y, const pt::RenderSettings& settings,
                   const std::vector<pt::BounceRange>& ranges, Row& row) {
  row.pixels.resize(view.width * ranges.size());
  for (int x = 0; x < view.width; ++x) {
    const pt::PixelApart apart = render_pixel_apart(view, x, y, settings, ranges);
    if (!apart.complete) {
      throw pt::Error(std::string(kRangesNotApart) +
                      ": they do not add up to what trace_path returned");
    }
    row.head.not_finite += apart.not_finite;
    for (std::size_t i = 0; i < ranges.size(); ++i) {
      row.pixels[i * view.width + x] = row_pixel(apart.pixels[i], -1);
    }
  }
}

Row render_row(const pt::View& view, int y, const pt::RenderSettings& settings,
               const std::vector<pt::BounceRange>& ranges) {
  Row row;
  const double start = pt::thread_cpu_seconds();
  const std::int64_t rays_before = rays();
  const pt::TestCount before = pt::recorder.count;
  if (ranges.empty()) {
    render_pixels(view, y, settings, row);
  } else {
    render_ranges(view, y, settings, ranges, row);
  }
  row.head.cpu_seconds = pt::thread_cpu_seconds() - start;
  row.head.rays = rays() - rays_before;
  row.head.boxes = pt::recorder.count.boxes - before.boxes;
  row.head.triangles = pt::recorder.count.triangles - before.triangles;
  row.head.spheres = pt::recorder.count.spheres - before.spheres;
  return row;
}

// The tasks that were called but are not written yet. Without a tree the picture is still right.
std::vector<std::string> missing_tasks(const Spec& spec, pt::Engine engine) {
  std::vector<std::string> missing;
  for (const std::string& task : tasks_used(spec)) {
    const bool of_tree = std::ranges::count(pt::kTreeTasks, task) > 0;
    if (of_tree && engine == pt::Engine::linear) continue;
    if (pt::todo_reached(task)) missing.push_back(task);
  }
  return missing;
}

int run(const std::string& spec_file, const Band& band) {
  const Spec spec = read_spec(spec_file);
  pt::LoadedScene loaded = pt::load_collada(spec.scene);
  if (!spec.path.show_normals) require_light(loaded, spec.scene);
  choose_engine(loaded.scene, spec.engine, kMaxLeaf);
  const pt::View view{loaded.scene,
                      frame_camera(loaded, spec.framing, spec.frame_width, spec.frame_height),
                      spec.path, spec.width, spec.height};
  const pt::RenderSettings settings{spec.samples, spec.adaptive, spec.seed, 1};
  for (int y = start_band(band, spec.row_pixels()); y < band.first_row + band.rows; ++y) {
    append_row(band.file(), render_row(view, y, settings, spec.ranges));
  }
  const pt::Engine engine = loaded.scene.tracer.engine();
  finish_band(band, {missing_tasks(spec, engine), std::string(pt::name(engine)),
                     loaded.scene.primitives.size()});
  return 0;
}

}  // namespace
}  // namespace measure

int main(int argc, char** argv) {
  return pt::run_program([&] {
    if (argc != 3) throw pt::Error("writeup_render SPEC.json FOLDER/FIRST+ROWS");
    return measure::run(argv[1], measure::band_of(argv[2]));
  });
}
