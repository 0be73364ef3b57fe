#include "grader/service/judging/name_mistakes.h"

#include "grader/base/parallel.h"
#include "grader/mistakes/naming.h"
#include "grader/service/judging/ask_battery.h"
#include "pt/file.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>

namespace grader::judging {

namespace {

// The seed is constant, so that a mistake's name, and the points for it, do not depend on luck.
constexpr std::uint64_t kSeed = 1;

bool fails_by_its_promises(const Judged& judged) {
  const results::State state = judged.result.state;
  const bool fails = state == results::State::fail || state == results::State::crash ||
                     state == results::State::timeout;
  return fails && judged.object.ok() && judged.result.reason.empty();
}

std::optional<mistakes::Evidence> evidence_of(const build::Config& config,
                                              const build::Builder& builder,
                                              const GradeRequest& request, const Judged& judged) {
  const build::Built worker = link_alone(config, builder, judged, Elsewhere::answers);
  if (!worker.ok()) return std::nullopt;
  const Trial trial{*judged.config, worker, false, request, {}};
  const auto answers = ask_battery(builder, trial, kSeed, 1);
  if (!answers) return std::nullopt;
  mistakes::Evidence evidence{*answers, {}};
  for (const results::PromiseResult& promise : judged.result.promises) {
    if (!promise.bonus && !promise.held) evidence.broken.insert(promise.name);
  }
  return evidence;
}

results::Mistake described(const std::vector<const mistakes::Fingerprint*>& found) {
  results::Mistake mistake;
  for (const mistakes::Fingerprint* each : found) {
    mistake.name += (mistake.name.empty() ? "" : ", ") + each->name;
    if (mistake.sentence.find(each->sentence) != std::string::npos) continue;
    mistake.sentence += (mistake.sentence.empty() ? "" : " Or: ") + each->sentence;
  }
  if (mistake.empty()) return mistake;
  mistake.hint = found[0]->hint;
  mistake.found_by = "battery";
  return mistake;
}

}  // namespace

std::string known_path(const build::TaskConfig& task) {
  const std::string name = "known." + task.slug + ".json";
  return std::filesystem::path(task.graded).replace_filename(name);
}

void name_mistakes(const build::Config& config, const build::Builder& builder,
                   const GradeRequest& request, std::vector<Judged>& judged,
                   const std::function<void()>& progress) {
  std::vector<Judged*> failing;
  for (Judged& each : judged) {
    if (fails_by_its_promises(each)) failing.push_back(&each);
  }
  std::mutex mutex;
  base::for_each(failing.size(), request.threads, [&](std::size_t i) {
    const std::string path = known_path(*failing[i]->config);
    if (!std::filesystem::exists(path)) return;
    const mistakes::KnownTask known = mistakes::known_from_json(pt::read_file(path), path);
    const auto evidence = evidence_of(config, builder, request, *failing[i]);
    if (!evidence) return;
    const std::map<std::string, double> likeness = mistakes::likeness(known, *evidence);
    for (results::PromiseResult& promise : failing[i]->result.promises) {
      if (const auto found = likeness.find(promise.name); found != likeness.end())
        promise.likeness = found->second;
    }
    if (mistakes::shows_nothing(evidence->answers)) return;
    const auto found = mistakes::name_by_battery(known, *evidence);
    if (found.empty()) return;
    for (results::PromiseResult& promise : failing[i]->result.promises) {
      const bool explained = std::ranges::any_of(
          found, [&](const auto* mistake) { return mistake->breaks == promise.name; });
      promise.likeness = explained ? 1 : 0;
    }
    results::Mistake mistake = described(found);
    mistake.always_the_same = mistakes::always_the_same(evidence->answers);
    const std::lock_guard lock(mutex);
    failing[i]->result.mistake = mistake;
    progress();
  });
}

}  // namespace grader::judging
