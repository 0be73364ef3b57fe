#include "measure/renders/band.h"
#include "measure/renders/rows.h"
#include "pt/error.h"
#include "pt/render/choose_engine.h"
#include "pt/scene/frame_camera.h"
#include "pt/scene/load_collada.h"

#include <algorithm>

namespace measure {

namespace {

RowPixel row_pixel(const Spec& spec, const pt::PictureRows& made, std::size_t i) {
  const pt::Rgb mean = is_finite(made.mean[i]) ? made.mean[i] : pt::Rgb{};
  const auto value = [&](const std::vector<double>& values) {
    return values.empty() ? -1.F : static_cast<float>(values[i]);
  };
  const int samples = made.counts.empty() ? spec.samples : made.counts[i];
  return {{static_cast<float>(mean.r), static_cast<float>(mean.g), static_cast<float>(mean.b)},
          samples < 2 ? -1 : value(made.measured.variance_y),
          samples,
          value(made.measured.boxes)};
}

// A row of the file for each row that was made. The sums are divided among the rows.
void append(const Band& band, const Spec& spec, const CostedRows& made, int rows) {
  const auto& [tests, not_finite] =
      std::tie(made.rows.measured.tests, made.rows.measured.not_finite);
  for (int y = 0; y < rows; ++y) {
    const auto share = [&](std::int64_t all) { return all * (y + 1) / rows - all * y / rows; };
    Row row;
    row.head = {made.cpu_seconds / rows, share(made.rays),     share(tests.boxes),
                share(tests.triangles),  share(tests.spheres), share(not_finite)};
    for (int x = 0; x < spec.row_pixels(); ++x) {
      row.pixels.push_back(
          row_pixel(spec, made.rows, static_cast<std::size_t>(y) * spec.row_pixels() + x));
    }
    append_row(band.file(), row);
  }
}

// Without a tree the picture is still right.
std::vector<std::string> missing_tasks(const Spec& spec, pt::Engine engine) {
  std::vector<std::string> missing;
  const std::set<std::string> used = tasks_used(spec);
  for (const std::string& task : unwritten_tasks()) {
    const bool of_tree = std::ranges::count(pt::kTreeTasks, task) > 0;
    if (used.contains(task) && !(of_tree && engine == pt::Engine::linear)) missing.push_back(task);
  }
  return missing;
}

}  // namespace

// Finished rows stay if the program is ended, so requests begin with one row, and get larger while they are quick.
void make_band(const std::string& spec_file, const Band& band) {
  const Spec spec = read_spec(spec_file);
  pt::LoadedScene loaded = pt::load_collada(spec.scene);
  if (!spec.path.show_normals) require_supported(loaded, spec.scene);
  const pt::View view{loaded.scene,
                      frame_camera(loaded, spec.framing, spec.frame_width, spec.frame_height),
                      spec.path, spec.width, spec.height};
  give_tracer(loaded.scene, view, spec.engine);
  const int end = band.first_row + band.rows;
  int most = 1;
  for (int y = start_band(band, spec.row_pixels()); y < end;) {
    const int rows = std::min(most, end - y);
    const CostedRows made =
        costed_rows(view, {y, rows, spec.samples, spec.adaptive, spec.seed, spec.ranges, {}});
    if (!made.rows.measured.apart) {
      throw pt::Error(std::string(kRangesNotApart) +
                      ": they do not add up to what trace_path returned");
    }
    append(band, spec, made, rows);
    if (made.cpu_seconds < kQuick) most *= 2;
    y += rows;
  }
  const pt::Engine engine = loaded.scene.tracer.engine();
  finish_band(band, {missing_tasks(spec, engine), std::string(pt::name(engine)),
                     loaded.scene.primitives.size()});
}

}  // namespace measure
