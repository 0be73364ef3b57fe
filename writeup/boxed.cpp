#include "writeup/boxed.h"

#include "grader/base/sha256.h"
#include "grader/judge/together.h"
#include "grader/process/process_time.h"
#include "grader/wire/session.h"
#include "pt/error.h"
#include "pt/file.h"
#include "writeup/worker_config.h"

#include <nlohmann/json.hpp>
#include <unistd.h>

namespace writeup {

using namespace grader;
using namespace grader::judge;

namespace {

constexpr std::size_t kMaxJson = std::size_t{1} << 22;
constexpr int kCompileSeconds = 60;
constexpr std::chrono::hours kTotalLimit{5};

std::string why_not(const Judged& judged) {
  const results::TaskResult& result = judged.result;
  return result.reason + (result.compiler_output.empty() ? "" : ":\n" + result.compiler_output);
}

}  // namespace

// The reference stands for what cannot be compiled, so that the rest can be looked at; a figure that
// needs it says so instead.
Boxed build_submission(const std::string& submission) {
  const Config config = worker_config("writeup_boxed.json");
  GradeRequest request;
  request.submission = base::submission_root(submission);
  request.isolation = sandbox::probe_isolation(config.root, config.work);
  const Builder builder(config, request.isolation.tier, kCompileSeconds);
  std::vector<Judged> judged;
  for (const TaskConfig& task : config.tasks) judged.push_back(not_judged(config, task));
  compile_all(builder, request, judged);
  Boxed boxed;
  for (Judged& each : judged) {
    each.right_alone = each.object.ok();  // link_together() leaves out what is not
    boxed.hash[each.config->slug] = base::sha256(each.content);
    if (!each.object.ok()) boxed.unusable[each.config->slug] = why_not(each);
  }
  const Built worker = link_together(config, builder, judged, Elsewhere::reference);
  if (!worker.ok()) throw pt::Error("it does not link: " + worker.error);
  std::string framework;
  for (const auto* objects : {&config.framework, &config.recording, &config.radiance}) {
    for (const std::string& object : *objects) framework += base::stamp(object);
  }
  boxed.hash["framework"] = base::sha256(framework);
  boxed.worker = worker.path;
  boxed.tier = std::string(1, letter(request.isolation.tier));
  return boxed;
}

void write_boxed(const Boxed& boxed, const std::string& file) {
  const nlohmann::json all{{"worker", boxed.worker},
                           {"tier", boxed.tier},
                           {"hash", boxed.hash},
                           {"unusable", boxed.unusable}};
  pt::write_file(file, all.dump());
}

Boxed read_boxed(const std::string& file) {
  const auto in = nlohmann::json::parse(pt::read_file(file, kMaxJson));
  return {in.at("worker"), in.at("tier"), in.at("hash"), in.at("unusable")};
}

void open_worker(const std::string& worker, const std::string& tier,
                 std::chrono::milliseconds call_limit) {
  wire::SessionSettings settings;
  settings.task = "the write-up";
  settings.program = worker;
  settings.tier = sandbox::tier_of(tier);
  settings.answers = false;
  settings.give_up = [](results::Cause, const std::string& text) { throw SubmissionFailed(text); };
  settings.call_limit = call_limit;
  settings.total_limit = kTotalLimit;
  settings.max_timeouts = 1;
  settings.max_failures = 1;
  wire::open_session(settings);
}

double worker_seconds() {
  return std::chrono::duration<double>(process::time_of_tree(getpid()).running).count();
}

}  // namespace writeup
