#include "grader/self_check/measure_mistakes.h"

#include "grader/base/files.h"
#include "grader/base/sha256.h"
#include "grader/judge/alone.h"
#include "grader/judge/ask_battery.h"
#include "grader/process/run_command.h"
#include "grader/results/read_json.h"
#include "grader/self_check/naming_variations.h"
#include "pt/error.h"
#include "pt/file.h"

#include <algorithm>
#include <span>
#include <sstream>

#include <nlohmann/json.hpp>

namespace grader::self_check {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::uint64_t kSeedOfAnswers = 20240607, kSeedOfTrial = 5;
constexpr int kDraws = 8;
constexpr std::uint64_t kPromiseSeeds[] = {1, 12};  // 1: the default of a grading
constexpr std::chrono::seconds kPromiseTime{300};

std::string hash_of(const std::vector<fs::path>& files) {
  std::string all;
  for (const fs::path& file : files) all += file.filename().string() + '\0' + base::read_file(file);
  return base::sha256(all).substr(0, 16);
}

std::vector<fs::path> sources_of(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const fs::path extension = entry.path().extension();
    if (extension == ".cpp" || extension == ".h") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::string text_of(const judge::Config& config, const Variation& variation) {
  const std::string path =
      config.root + "/grader/tasks/" + variation.task + "/right/" + variation.right + ".cpp";
  std::string text = base::read_file(path);
  const std::size_t at = text.find(variation.from);
  if (at == std::string::npos) throw pt::Error(path + " has no '" + variation.from + "'");
  return text.replace(at, variation.from.size(), variation.to);
}

// Returns, for the name of each promise, whether it holds at the seed.
std::map<std::string, bool> promises_at(const judge::Trial& trial, const std::string& report,
                                        std::uint64_t seed) {
  const std::vector<std::string> command{
      trial.task.graded,
      "--worker",
      trial.worker.path,
      "--report",
      report,
      "--seed",
      std::to_string(seed),
      "--isolation",
      std::string(1, sandbox::letter(trial.request.isolation.tier)),
      "--no-shrinking"};
  fs::remove(report);
  process::run_command({command, {"PATH=/usr/bin", "LANG=C.UTF-8"}, {}, "", {}}, kPromiseTime);
  std::map<std::string, bool> held;
  const results::Results all = results::read_results(report);
  for (const results::PromiseResult& promise : all.tasks.at(0).promises) {
    if (!promise.bonus) held[promise.name] = promise.held;
  }
  return held;
}

struct Promises {
  std::set<std::string> broken_at_first, kept_at_first;  // at the first seed
  std::vector<std::string> broken, unsure;               // at all seeds, and at some
};

Promises promises_of(const judge::Trial& trial, const std::string& report,
                     std::span<const std::uint64_t> seeds) {
  Promises promises;
  std::map<std::string, int> broken;
  for (const std::uint64_t seed : seeds) {
    for (const auto& [name, held] : promises_at(trial, report, seed)) {
      broken[name] += held ? 0 : 1;
      if (seed == seeds.front())
        (held ? promises.kept_at_first : promises.broken_at_first).insert(name);
    }
  }
  for (const auto& [name, times] : broken) {
    const bool always = times == static_cast<int>(seeds.size());
    if (always) promises.broken.push_back(name);
    if (times > 0 && !always) promises.unsure.push_back(name);
  }
  return promises;
}

// The measurement with these promises.
MeasuredSolution with_promises(MeasuredSolution measured, const Promises& promises) {
  measured.trial.broken = promises.broken_at_first;
  measured.trial.kept = promises.kept_at_first;
  measured.broken = promises.broken;
  measured.unsure = promises.unsure;
  return measured;
}

MeasuredSolution read_stored(const std::string& path) {
  if (!fs::exists(path)) return {};
  const json from = json::parse(base::read_file(path));
  MeasuredSolution measured;
  from.at("source").get_to(measured.source);
  from.at("battery").get_to(measured.battery);
  from.at("properties").get_to(measured.properties);
  from.at("broken").get_to(measured.broken);
  from.at("unsure").get_to(measured.unsure);
  from.at("trial_broken").get_to(measured.trial.broken);
  from.at("trial_kept").get_to(measured.trial.kept);
  measured.answers = mistakes::answers_from_json(from.at("answers").dump());
  measured.trial.answers = mistakes::answers_from_json(from.at("trial_answers").dump());
  return measured;
}

void store_measured(const std::string& path, const MeasuredSolution& measured) {
  const json all{{"source", measured.source},
                 {"battery", measured.battery},
                 {"properties", measured.properties},
                 {"broken", measured.broken},
                 {"unsure", measured.unsure},
                 {"trial_broken", measured.trial.broken},
                 {"trial_kept", measured.trial.kept},
                 {"answers", json::parse(to_json(measured.answers))},
                 {"trial_answers", json::parse(to_json(measured.trial.answers))}};
  pt::write_file(path, all.dump() + "\n");
}

mistakes::Answers ask(const judge::Builder& builder, const judge::Trial& trial, std::uint64_t seed,
                      int draws) {
  const auto answers = judge::ask_battery(builder, trial, seed, draws);
  if (!answers) throw pt::Error("the battery cannot be asked of " + trial.worker.path);
  return *answers;
}

}  // namespace

std::vector<Kept> kept_solutions(const judge::Config& config, const judge::TaskConfig& task,
                                 const std::vector<std::string>& kinds) {
  std::vector<Kept> all;
  for (const std::string& kind : kinds) {
    if (kind == "reference") {
      const fs::path file = fs::path(config.root) / "reference" / task.file();
      all.push_back({&task, kind, task.slug, base::read_file(file)});
      continue;
    }
    if (kind == "variation") {
      for (const Variation& each : naming_variations()) {
        if (each.task == task.slug)
          all.push_back({&task, kind, each.mistake, text_of(config, each)});
      }
      continue;
    }
    const fs::path folder = fs::path(config.root) / "grader/tasks" / task.slug / kind;
    if (!fs::is_directory(folder)) continue;
    for (const fs::path& file : sources_of(folder)) {
      if (file.extension() == ".cpp") {
        all.push_back({&task, kind, file.stem().string(), base::read_file(file)});
      }
    }
  }
  return all;
}

MeasuredSolution measure(const judge::Config& shared, const judge::GradeRequest& request,
                         const Kept& kept, const std::string& store, Extent extent) {
  const std::string path = store + "/" + kept.key() + ".json";
  MeasuredSolution measured = read_stored(path);
  const std::string source = base::sha256(kept.text).substr(0, 16);
  const std::string battery = battery_hash(shared.root, kept.task->slug);
  const std::string properties = properties_hash(shared.root, kept.task->slug);
  const bool same = measured.source == source;
  const bool answered = same && measured.battery == battery;
  const bool judged = same && measured.properties == properties;
  if (answered && judged) return measured;

  judge::Config config = shared;
  config.work = store;
  const judge::Builder builder(config, request.isolation.tier, request.compile_limit);
  judge::Judged built;
  built.config = kept.task;
  built.object = builder.compile(*kept.task, kept.text);
  if (!built.object.ok()) throw pt::Error(kept.key() + " is refused: " + built.object.error);
  const judge::Built worker = judge::link_alone(config, builder, built, judge::Elsewhere::answers);
  if (!worker.ok()) throw pt::Error(kept.key() + " does not link: " + worker.error);
  const judge::Trial trial{*kept.task, worker, false, request, {}};
  const std::span seeds(kPromiseSeeds);
  if (!answered) measured.trial.answers = ask(builder, trial, kSeedOfTrial, 1);
  if (extent == Extent::trial) {
    if (judged) return measured;
    return with_promises(measured, promises_of(trial, path + ".report", seeds.first(1)));
  }
  if (!answered) measured.answers = ask(builder, trial, kSeedOfAnswers, kDraws);
  if (!judged) measured = with_promises(measured, promises_of(trial, path + ".report", seeds));
  measured.source = source;
  measured.battery = battery;
  measured.properties = properties;
  store_measured(path, measured);
  return measured;
}

std::string battery_hash(const std::string& root, const std::string& slug) {
  const fs::path folder = fs::path(root) / "grader/mistakes";
  std::vector<fs::path> files{folder / "battery.cpp", folder / "battery.h", folder / "pixels.h",
                              folder / "patches.h"};
  for (const fs::path& file : sources_of(folder)) {
    if (file.filename().string().starts_with(slug)) files.push_back(file);
  }
  // A battery also uses headers of the properties.
  for (const fs::path& file : sources_of(fs::path(root) / "grader/tasks" / slug)) {
    if (file.extension() == ".h") files.push_back(file);
  }
  return hash_of(files);
}

std::string properties_hash(const std::string& root, const std::string& slug) {
  const fs::path grader = fs::path(root) / "grader";
  std::vector<fs::path> files = sources_of(grader / "tasks" / slug);
  for (const fs::path& file : sources_of(grader / "check")) files.push_back(file);
  // Curves and searches judge nothing.
  std::erase_if(files, [](const fs::path& file) {
    const std::string name = file.stem();
    return name.starts_with("curve") || name == "searches";
  });
  return hash_of(files);
}

std::string sentence_of(const std::string& text) {
  std::istringstream lines(text);
  std::string sentence;
  bool first = true;
  for (std::string line; std::getline(lines, line) && line.starts_with("//"); first = false) {
    if (first) continue;
    const std::size_t start = line.find_first_not_of("/ ");
    if (start == std::string::npos) break;
    sentence += (sentence.empty() ? "" : " ") + line.substr(start);
  }
  return sentence;
}

}  // namespace grader::self_check
