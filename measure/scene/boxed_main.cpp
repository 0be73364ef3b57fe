// accuracy_boxed cheapest | converge SCENE --submission DIR: the same for a submission, without
// running its code in this process. The exit status is 1 if the submission cannot be measured.
#include "grader/service/process/spawn.h"
#include "grader/service/wire/session.h"
#include "grader/service/wire/worker_rows.h"
#include "measure/renders/boxed.h"
#include "measure/renders/spec.h"
#include "measure/scene/begin.h"
#include "measure/scene/pixels_apart.h"
#include "pt/end_of_program.h"
#include "pt/scene/tracer.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>

namespace measure::scene {

using namespace grader;

namespace {

constexpr std::chrono::seconds kCallLimit{20};  // of processor time; a call takes about kQuick
constexpr double kQuick = 0.3;                  // seconds
constexpr std::size_t kFirstPiece = 4, kLargestPiece = 2048;  // pixels per call

std::set<std::string> does_not_compile;  // tasks of this program's submission

long long rays_so_far() { return pt::rays_traced().closest + pt::rays_traced().occluded; }

// All pixels, in pieces that take about as long as kQuick. take(first, answer) is called for each.
template <class Take>
void make_pieces(const pt::View& view, pt::RowsRequest request, std::span<const PixelAt> pixels,
                 const Take& take) {
  std::size_t piece = kFirstPiece;
  for (std::size_t first = 0; first < pixels.size();) {
    request.only.clear();
    for (std::size_t i = first; i < std::min(first + piece, pixels.size()); ++i) {
      request.only.push_back(pixels[i].y * view.width + pixels[i].x);
    }
    const auto start = std::chrono::steady_clock::now();
    take(first, wire::worker_rows(view, request));
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
    first += request.only.size();
    if (passed.count() < kQuick / 2) piece = std::min(2 * piece, kLargestPiece);
    if (passed.count() > kQuick) piece = std::max(piece / 2, kFirstPiece);
  }
}

pt::RowsRequest request_of(const pt::RenderSettings& settings) {
  return {0, 1, settings.samples, settings.adaptive, settings.seed, {}, {}};
}

double luminance_of(const pt::Rgb& mean) { return is_finite(mean) ? luminance(mean) : 0; }

// From now on this submission renders the pixels. Throws SubmissionFailed if a task that all pixels
// need does not compile.
void open_boxed(const Boxed& boxed, pt::Engine engine) {
  Spec needed;
  needed.engine = engine;
  needed.path.to = 1;
  for (const std::string& task : tasks_used(needed)) {
    const auto found = boxed.unusable.find(task);
    if (found != boxed.unusable.end()) throw SubmissionFailed(task + " " + found->second);
  }
  for (const auto& [task, reason] : boxed.unusable) does_not_compile.insert(task);
  open_worker(boxed.worker, boxed.tier, kCallLimit);
}

}  // namespace

RenderedPixels measure(const pt::View& view, const pt::RenderSettings& settings,
                       std::span<const PixelAt> pixels) {
  RenderedPixels result{std::vector<double>(pixels.size()), std::vector<double>(pixels.size()),
                        std::vector<int>(pixels.size())};
  const double before = worker_seconds();
  const long long rays_before = rays_so_far();
  make_pieces(view, request_of(settings), pixels,
              [&](std::size_t first, const pt::PictureRows& answer) {
                for (std::size_t i = 0; i < answer.mean.size(); ++i) {
                  const bool adaptive = !answer.counts.empty();
                  result.mean[first + i] = luminance_of(answer.mean[i]);
                  result.variance[first + i] = answer.measured.variance_y.at(i);
                  result.samples[first + i] = adaptive ? answer.counts[i] : settings.samples;
                }
              });
  result.cpu_seconds = worker_seconds() - before;
  result.rays = rays_so_far() - rays_before;
  return result;
}

MeasuredApart measure_apart(const pt::View& view, const pt::RenderSettings& settings,
                            std::span<const pt::BounceRange> ranges,
                            std::span<const PixelAt> pixels) {
  MeasuredApart result;
  result.mean.assign(ranges.size(), std::vector<double>(pixels.size()));
  const double before = worker_seconds();
  pt::RowsRequest request = request_of(settings);
  request.ranges.assign(ranges.begin(), ranges.end());
  make_pieces(view, request, pixels, [&](std::size_t first, const pt::PictureRows& answer) {
    if (!answer.measured.apart) throw SubmissionFailed(kNotApart);
    const std::size_t count = answer.mean.size() / ranges.size();
    for (std::size_t k = 0; k < ranges.size(); ++k) {
      for (std::size_t i = 0; i < count; ++i) {
        result.mean[k][first + i] = luminance_of(answer.mean[k * count + i]);
      }
    }
  });
  result.cpu_seconds = worker_seconds() - before;
  return result;
}

std::vector<std::string> unwritten_tasks() {
  std::set<std::string> tasks = wire::session().record().todo;
  tasks.insert(does_not_compile.begin(), does_not_compile.end());
  return {tasks.begin(), tasks.end()};
}

}  // namespace measure::scene

int main(int argc, char** argv) {
  using namespace measure::scene;
  grader::process::hide_process();
  std::signal(SIGPIPE, SIG_IGN);
  return pt::run_program([&] {
    try {
      Call call = parse_call(argc, argv);
      Options& options = call.options;
      open_boxed(options.built.empty() ? measure::build_submission(options.submission)
                                       : measure::read_boxed(options.built),
                 options.engine);
      options.threads = 1;  // there is one worker
      run_call(call);
      return 0;
    } catch (const measure::SubmissionFailed& error) {
      std::fprintf(stderr, "the submission cannot be measured: %s\n",
                   pt::sentence_of(error).c_str());
      return 1;
    }
  });
}
