#include "view/worker/picture.h"

#include "pt/render/darkness.h"
#include "pt/render/threads.h"
#include "pt/scene/recorder.h"
#include "pt/tasks/camera_ray.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>

namespace view {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int kCoarse = 4;
constexpr int kFirstPass = 2,
              kMaxPass = 16;  // samples; one sample would go through the centre of the pixel
constexpr long long kMaxSamples = 1 << 16;
constexpr std::size_t kMaxBad = 20;

// The picture that a stage renders: the first two have fewer pixels.
pt::View view_of_stage(const Picture& picture) {
  pt::View view = picture.view;
  if (picture.stage >= 2) return view;
  view.settings.show_normals = picture.stage == 0;
  view.width = (view.width + kCoarse - 1) / kCoarse;
  view.height = (view.height + kCoarse - 1) / kCoarse;
  return view;
}

int samples_of(const Picture& picture) {
  if (picture.stage < 2) return 1;
  return std::min(kFirstPass << std::min(picture.stage - 2, 8), kMaxPass);
}

// The tests or the surface that a false colour shows for a pixel, from its first ray.
double looked_up(const Picture& picture, int x, int y) {
  const pt::View& view = picture.view;
  const pt::Ray ray = camera_ray(view.camera, (x + 0.5) / view.width, (y + 0.5) / view.height);
  const auto hit = view.scene.closest(ray);
  if (!hit) return std::nan("");
  return picture.settings.shown == Shown::distance ? hit->t : hit->primitive;
}

double number_shown(const Picture& picture, const Picture::Sum& sum, int x, int y) {
  const auto n = static_cast<double>(std::max(sum.samples, 1LL));
  switch (picture.settings.shown) {
    case Shown::boxes:
    case Shown::primitives_tested:
    case Shown::points:
      return sum.counted / n;
    case Shown::samples:  // per pass
      return picture.stage < 2 ? n : n / (picture.stage - 1);
    case Shown::deviation:
      return n > 1 ? std::sqrt(sum.squares / (n - 1)) : 0;
    case Shown::light:
      return 0;
    case Shown::primitive:
    case Shown::distance:
      break;
  }
  return looked_up(picture, x, y);
}

void add(Picture::Sum& sum, const pt::FilmPixel& pixel, double counted) {
  const auto n = static_cast<double>(sum.samples), m = static_cast<double>(pixel.samples);
  const double step = luminance(pixel.mean) - luminance(sum.mean);
  sum.mean = (sum.mean * n + pixel.mean * m) / (n + m);
  sum.squares += pixel.variance_y * (m - 1) + step * step * n * m / (n + m);
  sum.counted += counted;
  sum.samples += pixel.samples;
}

// The surfaces that paths met. Rays in search of direct light belong to the calls that cast them.
double points_in(const std::vector<pt::Call>& calls) {
  double points = 0;
  for (std::size_t i = 0; i < calls.size(); i = calls[i].end) {
    if (calls[i].name != "closest") continue;
    points += std::any_cast<std::optional<pt::Hit>>(calls[i].out).has_value() ? 1 : 0;
  }
  return points;
}

// A pixel, and what a false colour counts in it.
std::pair<pt::RenderedPixel, double> counted_pixel(const pt::View& view, int x, int y,
                                                   const pt::RenderSettings& pass, Shown shown) {
  std::vector<pt::Call> calls;
  const pt::TestCount before = pt::recorder.count;
  pt::recorder.calls = shown == Shown::points ? &calls : nullptr;
  const pt::RenderedPixel rendered = render_pixel(view, x, y, pass);
  pt::recorder.calls = nullptr;
  const pt::TestCount& after = pt::recorder.count;
  if (shown == Shown::points) return {rendered, points_in(calls)};
  if (shown == Shown::boxes) return {rendered, static_cast<double>(after.boxes - before.boxes)};
  return {rendered,
          static_cast<double>(after.triangles + after.spheres - before.triangles - before.spheres)};
}

// One pixel of the stage; y counts from the bottom.
void render(Picture& picture, const pt::View& view, int x, int y, std::mutex& noting) {
  const Settings& settings = picture.settings;
  pt::RenderSettings pass{samples_of(picture), {}, settings.render.seed, 1};
  if (picture.stage >= 2) {
    pass.adaptive = settings.render.adaptive;
    pass.seed += static_cast<std::uint64_t>(picture.stage - 2) << 32;
  }
  const auto [rendered, counted] = counted_pixel(view, x, y, pass, settings.shown);
  const int size = picture.stage < 2 ? kCoarse : 1;
  Picture::Sum coarse;
  Picture::Sum& sum =
      size > 1 ? coarse : picture.sums[static_cast<std::size_t>(y) * picture.view.width + x];
  add(sum, rendered.pixel, counted);
  pt::Rgb value = sum.mean;
  if (settings.shown != Shown::light) {
    value = pt::gray(number_shown(picture, sum, std::min(x * size, picture.view.width - 1),
                                  std::min(y * size, picture.view.height - 1)));
  }
  for (int py = y * size; py < std::min((y + 1) * size, picture.view.height); ++py) {
    for (int px = x * size; px < std::min((x + 1) * size, picture.view.width); ++px) {
      const std::size_t at =
          3 * (static_cast<std::size_t>(picture.view.height - 1 - py) * picture.view.width + px);
      for (int c = 0; c < 3; ++c) picture.shown[at + c] = static_cast<float>(value[c]);
    }
  }
  if (rendered.not_finite == 0 || picture.stage < 2) return;
  const std::lock_guard lock(noting);
  picture.not_finite += rendered.not_finite;
  const bool is_known = std::ranges::any_of(
      picture.bad, [&](const pt::BadPixel& bad) { return bad.x == x && bad.y == y; });
  if (!is_known && picture.bad.size() < kMaxBad) picture.bad.push_back({x, y});
}

double brightest(const Picture& picture) {
  double most = 0;
  for (const Picture::Sum& sum : picture.sums) most = std::max(most, max_channel(sum.mean));
  return most;
}

}  // namespace

Picture begin_picture(const pt::LoadedScene& loaded, const Settings& settings) {
  Picture picture{settings, view_of(loaded, settings)};
  const std::size_t pixels = static_cast<std::size_t>(picture.view.width) * picture.view.height;
  picture.shown.resize(3 * pixels);
  picture.sums.resize(pixels);
  return picture;
}

bool improve(Picture& picture, std::chrono::milliseconds time) {
  if (picture.samples >= kMaxSamples) return false;
  const auto start = Clock::now();
  const pt::View view = view_of_stage(picture);
  const int pixels = view.width * view.height;
  std::atomic<int> next = picture.next_pixel;
  std::mutex noting;
  pt::in_threads(picture.settings.render.threads, [&](int) {
    const pt::RayCount before = pt::rays_traced();
    while (Clock::now() - start < time) {
      const int pixel = next++;
      if (pixel >= pixels) break;
      render(picture, view, pixel % view.width, pixel / view.width, noting);
    }
    const pt::RayCount after = pt::rays_traced();
    const std::lock_guard lock(noting);
    picture.rays.closest += after.closest - before.closest;
    picture.rays.occluded += after.occluded - before.occluded;
  });
  picture.next_pixel = std::min(next.load(), pixels);
  picture.seconds += std::chrono::duration<double>(Clock::now() - start).count();
  if (picture.next_pixel < pixels) return true;
  if (picture.stage >= 2) picture.samples += samples_of(picture);
  picture.next_pixel = 0;
  ++picture.stage;
  // The page has a control for the exposure.
  const bool is_first = picture.stage == 3;
  if (is_first || !picture.note.empty()) {
    picture.note = note_on_darkness(picture.view, brightest(picture), 1);
  }
  // Normals, and what the first ray finds, are complete after one pass.
  const bool is_done = picture.stage == 3 && (picture.settings.shown == Shown::primitive ||
                                              picture.settings.shown == Shown::distance);
  if (is_done) picture.samples = kMaxSamples;
  return !is_done;
}

}  // namespace view
