#include "tests/grader/report/example_results.h"

#include "pt/image/image_io.h"
#include "pt/image/sample_map.h"

#include <cmath>
#include <random>

#include <fmt/format.h>

namespace {

using namespace grader::results;

constexpr int kWidth = 96, kHeight = 72;

struct Bias {
  FailingCell cell;
  double factor = 1;
  double noise = 0.05;  // relative deviation of a mean
};

// A soft gradient with a disc; one cell is biased.
pt::Film film(const Bias& bias, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  pt::Film out(kWidth, kHeight);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const bool disc = std::hypot(x - 60, y - 30) < 18;
      pt::Rgb mean = disc ? pt::Rgb{0.7, 0.3, 0.15} : pt::Rgb{0.35, 0.4, 0.45};
      const FailingCell& c = bias.cell;
      const bool inside = x >= c.x && x < c.x + c.width && y >= c.y && y < c.y + c.height;
      mean = (0.4 + 0.6 * y / kHeight) * (inside ? bias.factor : 1) *
             (1 + bias.noise * normal(random)) * mean;
      const double variance = 64 * std::pow(bias.noise * pt::luminance(mean), 2);
      out.set(x, y, {mean, {variance, variance, variance}, variance, 64});
    }
  }
  return out;
}

pt::SampleMap counts(double factor) {
  pt::SampleMap map{kWidth, kHeight, {}, 0};
  for (int i = 0; i < kWidth * kHeight; ++i) {
    const int row = i / kWidth;
    const double wave = 0.5 + 0.5 * std::sin(0.1 * (i % kWidth)) * std::cos(0.07 * row);
    map.counts.push_back(64 * std::max(1, static_cast<int>(factor * 32 * wave)));
  }
  return map;
}

PictureResult picture(const std::string& folder, const std::string& recipe, State state) {
  PictureResult out;
  out.recipe = recipe;
  out.title = "A disc in a gradient";
  out.state = state;
  out.samples = 64;
  out.rounds = 1;
  out.noise = 1.02;
  out.seconds = 0.8;
  out.max_points = 3;
  out.points = state == State::pass ? 3 : 0;
  out.width = kWidth;
  out.height = kHeight;
  out.golden = folder + "/golden.exr";
  out.render = folder + "/" + recipe + ".exr";
  out.replay = "./run grade direct_lights --seed 7";
  pt::write_exr(out.golden, film({{}, 1, 0}, 1));
  return out;
}

PictureResult wrong_picture(const std::string& folder) {
  PictureResult out = picture(folder, "penumbra", State::fail);
  out.text = "This block was 21.0 % too dark in three independent renders.";
  out.samples = 448;
  out.rounds = 3;
  out.cells = {{48, 24, 8, 8, "Y", -0.21, 2.4}, {56, 24, 4, 4, "R", -0.2, 1.3}};
  out.evidence = folder + "/evidence.exr";
  pt::write_exr(out.render, film({{40, 16, 24, 24, "Y"}, 0.79}, 2));
  pt::Film evidence(kWidth, kHeight);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const bool inside = x >= 40 && x < 64 && y >= 16 && y < 40;
      const double value = (inside ? 1.6 : 0.3) + 0.2 * std::sin(x / 8) * std::cos(y / 8);
      evidence.set(x, y, {{value, 0, 0}, {}, 0, 0});
    }
  }
  pt::write_exr(out.evidence, evidence);
  return out;
}

std::vector<PictureResult> pictures(const std::string& folder) {
  PictureResult right = picture(folder, "two_lights", State::pass);
  pt::write_exr(right.render, film({{}, 1}, 3));
  PictureResult noisy = picture(folder, "large_light", State::too_noisy);
  noisy.text = "It is right on average, but has 4.1 times the variance that it should have.";
  noisy.points = 1;
  noisy.noise = 4.1;
  pt::write_exr(noisy.render, film({{}, 1, 0.1}, 4));
  PictureResult lost = picture(folder, "lost", State::fail);
  lost.text = "The picture as a whole was 3.0 % too bright in three independent renders.";
  PictureResult never = picture(folder, "sheet", State::crash);
  never.text = "The process died (segmentation fault) after 0.2 s.";
  never.render.clear();
  return {right, wrong_picture(folder), noisy, lost, never};
}

PictureResult adaptive_picture(const std::string& folder) {
  PictureResult out = picture(folder, "adaptive", State::fail);
  out.text = "The sample map is 1.3 times as dense as it should be.";
  out.counts = folder + "/counts.csv";
  out.golden_counts = folder + "/golden_counts.csv";
  pt::write_exr(out.render, film({{}, 1}, 5));
  pt::write_counts(out.counts, counts(1.3));
  pt::write_counts(out.golden_counts, counts(1));
  return out;
}

TaskResult task(const std::string& part, const std::string& number, const std::string& slug,
                State state) {
  TaskResult out;
  out.part = part;
  out.number = number;
  out.slug = slug;
  out.state = state;
  out.max_points = 2;
  out.points = state == State::pass || state == State::blocked ? 2 : 0;
  for (const char* promise : {"keeps t inside the ray: no hit before t_min or after t_max",
                              "returns the interpolated normal, of unit length"}) {
    std::string name = promise;
    for (char& c : name) c = c == ' ' ? '_' : c;
    out.promises.push_back({name, promise, false, out.points == 2, 1, 0.4, {}});
  }
  return out;
}

void fail_promise(TaskResult& task, Cause cause) {
  task.promises[0].held = true;
  task.points = 1;
  Failure failure;
  failure.input = {"triangle {(0, 0, 0), (1, 0, 0), (0, 1, 0)}",
                   "ray {o (0.25, 0.25, 1), d (0, 0, -1)}"};
  failure.what = "t of the hit";
  failure.got = cause == Cause::wrong ? "-1" : "no answer";
  failure.expected = "1";
  failure.off_by = cause == Cause::wrong ? "2" : "";
  failure.cause = cause;
  failure.cases_before = 17;
  failure.seed = 7;
  failure.replay = "./run grade " + task.slug + " --seed 7";
  task.promises[1].failures = {failure};
}

// Every member of these structs has a distinct value.
PictureResult full_picture() {
  return {"w",
          "x1",
          State::too_noisy,
          "x",
          true,
          64,
          3,
          1.25,
          2.5,
          6,
          7,
          "x2",
          96,
          72,
          "x3",
          "x4",
          "x5",
          "x6",
          "x7",
          {{1, 2, 3, 4, "G", -0.5, 1.5}}};
}

TaskResult full_task() {
  const Failure failure{{"a", "b"}, "c", "d",  "e",        "f",  Cause::bad_reply,
                        true,       1,   true, 1ULL << 63, true, "h"};
  const PictureResult picture = full_picture();
  return {.part = "i",
          .number = "j",
          .slug = "k",
          .called = "A::b",
          .state = State::crash,
          .reason = "l",
          .points = 2,
          .max_points = 3,
          .bonus_points = 4,
          .spared = 1,
          .mistake = {"absolute_epsilon", "It is an epsilon.", "battery", "", false},
          .blocked_by = {"m"},
          .blamed = {"n", "o"},
          .compiler_output = "p\nq\n",
          .warnings = "w\n",
          .keeps_state = true,
          .printed = "\x1b\"r",
          .promises = {{"s", "t", true, true, 5, 0.1, {}},
                       {"u", "v", false, false, 6, 0.2, {failure, failure}}},
          .pictures = {picture, picture}};
}

}  // namespace

Results full_results() {
  const TaskResult task = full_task();
  TaskResult other = task;
  other.slug = "k2";
  return {"y",          5,
          "z",          {"v1", "v2"},
          "cmd",        "dialect",
          0.3,          {{"p1", 0.5}, {"p2", 0.25}},
          true,         {"aa", "bb"},
          {task, other}};
}

Results example_results(const std::string& folder) {
  TaskResult right = task("1_rays", "1.1", "estimate_pixel", State::pass);
  right.bonus_points = 1;
  TaskResult wrong = task("1_rays", "1.3", "hit_triangle", State::fail);
  fail_promise(wrong, Cause::wrong);
  TaskResult dead = task("1_rays", "1.4", "hit_sphere", State::crash);
  fail_promise(dead, Cause::crash);
  TaskResult endless = task("2_bvh", "2.1", "build_bvh", State::timeout);
  fail_promise(endless, Cause::timeout);
  TaskResult refused = task("2_bvh", "2.2", "hit_box", State::rejected);
  refused.reason = "2_bvh/hit_box.cpp is a link; the judge takes regular files.";
  TaskResult waits = task("2_bvh", "2.3", "hit_bvh", State::blocked);
  waits.blocked_by = {"hit_box"};
  TaskResult lit = task("3_direct", "3.3", "direct_lights", State::fail);
  lit.reason = "It fails only with your hit_bvh.";
  lit.blamed = {"hit_bvh"};
  lit.pictures = pictures(folder);
  lit.max_points += 15;
  lit.points = 6;
  for (PromiseResult& promise : lit.promises) promise.held = true;
  lit.printed = kHostile;
  TaskResult adaptive = task("5_adaptive", "5.1", "adaptive_pixel", State::too_noisy);
  adaptive.pictures = {adaptive_picture(folder), lit.pictures[0]};  // one picture judges two tasks
  adaptive.points = 5;
  adaptive.max_points += 6;
  for (PromiseResult& promise : adaptive.promises) promise.held = true;
  TaskResult unwritten = task("4_global", "4.1", "trace_path", State::not_attempted);
  Results results;
  results.submission = kHostile;
  results.seed = 7;
  results.isolation = "A: bubblewrap";
  results.versions = {"Firstlight 1.2.3", "commit 7084666", "g++ 12.2.0", "bubblewrap 0.8.0"};
  results.command = "./run grade --submission " + kHostile + " --seed 7";
  results.seconds = 27;
  results.phases = {{"properties", 5.9}, {"pictures", 21}};
  results.complete = true;
  results.tasks = {right, wrong, dead, endless, refused, waits, lit, unwritten, adaptive};
  for (const TaskResult& each : results.tasks) results.asked.push_back(each.slug);
  return results;
}
