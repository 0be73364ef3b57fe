#include "writeup/accuracy/begin.h"

#include "grader/base/files.h"
#include "grader/base/sha256.h"
#include "pt/error.h"
#include "writeup/accuracy/converge.h"
#include "writeup/accuracy/print.h"
#include "writeup/spec.h"

#include <csignal>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

namespace writeup::accuracy {

namespace {

// The journal of this call. Its name is a hash of everything that the measurements depend on.
Journal journal_of(const Call& call) {
  const Options& o = call.options;
  if (o.keep.empty()) return {};
  const std::string code = o.built.empty() ? "/proc/self/exe" : o.built;
  const std::string text =
      fmt::format("{} {} {} {} {} {} {} {} {} {} {} {} {} {} {} {}", static_cast<int>(call.command),
                  grader::base::stamp(code), grader::base::stamp(o.scene.string()), o.error,
                  o.bounces, o.width, o.height, static_cast<int>(o.framing),
                  static_cast<int>(o.engine), o.lambertian, o.seconds, o.seed, o.threads, o.pixels,
                  fmt::join(o.light_samples, ","), std::filesystem::absolute(o.scene).string());
  Journal journal(o.keep / grader::base::sha256(text).substr(0, 32));
  if (journal.goes_on()) fmt::print(stderr, "going on where the same command was stopped\n");
  return journal;
}

}  // namespace

namespace {

// The unwritten ones among the tasks without which there is no picture at all.
std::vector<std::string> unwritten_and_needed(pt::Engine engine) {
  Spec spec;
  spec.engine = engine;
  spec.path.to = 1;
  std::vector<std::string> tasks = unwritten_tasks();
  std::erase_if(tasks, [needed = tasks_used(spec)](const std::string& task) {
    return !needed.contains(task);
  });
  return tasks;
}

}  // namespace

Measuring::Measuring(pt::LoadedScene scene, const Call& call, int bounces, double share)
    : loaded(std::move(scene)),
      view{loaded.scene,
           frame_camera(loaded, call.options.framing, call.options.width, call.options.height),
           {},
           call.options.width,
           call.options.height},
      study(
          view, call.options.threads, call.options.seed,
          {share * call.options.seconds, 0, call.options.pixels},
          [this, share](double part) { progress.show(share * part); }, bounces, journal_of(call)) {
  const std::vector<std::string> unwritten = unwritten_and_needed(call.options.engine);
  print_notes(loaded);
  if (unwritten.empty() && !study.is_black()) return;
  progress.clear();
  if (unwritten.empty()) {
    throw pt::Error(
        "the picture is black: no light reaches this camera; choose another with --camera");
  }
  throw pt::Error(fmt::format("not written yet: {}; nothing can be measured without",
                              fmt::join(unwritten, ", ")));
}

namespace {

void run_cheapest(const Call& call) {
  const Options& options = call.options;
  Measuring scene(load_scene(options), call, kAllBounces);
  const Answer answer = find_cheapest(scene.study, scene.view, options);
  scene.progress.clear();
  fmt::print("{}", to_text(answer, options, scene.loaded.scene));
  if (!options.out.empty()) write_charts(answer, options, scene.loaded.scene);
  scene.study.forget_journal();
}

void run_converge(const Call& call) {
  const Options& options = call.options;
  pt::LoadedScene loaded = load_scene(options);
  const std::vector<Method> methods = methods_in(loaded.scene, options.bounces, options.engine);
  expect_method(methods, options.beside);
  Measuring scene(std::move(loaded), call, options.bounces);
  const std::vector<MethodCurve> curves = find_curves(scene.study, scene.view, methods);
  scene.progress.clear();
  fmt::print("{}", to_text(curves, options));
  if (!options.out.empty()) write_curves(curves, options, scene.study.cpu_seconds());
  scene.study.forget_journal();
}

}  // namespace

void say_when_stopped() {
  const auto stop = [](int) {
    const char words[] = "\nstopped; run the same command again to continue\n";
    [[maybe_unused]] const auto written = write(STDERR_FILENO, words, sizeof words - 1);
    _exit(130);
  };
  std::signal(SIGINT, stop);
  std::signal(SIGTERM, stop);
}

void run_call(const Call& call) {
  call.command == Command::cheapest ? run_cheapest(call) : run_converge(call);
}

}  // namespace writeup::accuracy
