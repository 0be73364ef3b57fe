#include "measure/renders/boxed.h"

#include "grader/base/sha256.h"
#include "grader/service/intake/taken_in.h"
#include "grader/service/judging/together.h"
#include "grader/service/process/process_time.h"
#include "grader/service/wire/session.h"
#include "grader/service/wire/worker_rows.h"
#include "measure/renders/rows.h"
#include "measure/renders/worker_config.h"
#include "pt/error.h"
#include "pt/file.h"
#include "pt/render/choose_engine.h"

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include <nlohmann/json.hpp>
#include <unistd.h>

namespace measure {

using namespace grader;
using namespace grader::judging;

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Boxed, worker, tier, hash, unusable)

namespace {

constexpr std::size_t kMaxJson = std::size_t{1} << 22;
constexpr int kCompileSeconds = 60;
constexpr std::chrono::hours kTotalLimit{5};

struct Opened {
  std::shared_ptr<wire::Session> session;
  std::set<std::string> does_not_compile;  // tasks of the submission
};
std::map<std::string, Opened> opened;  // by worker
const Opened* open_now = nullptr;

std::string why_not(const Judged& judged) {
  const results::TaskResult& result = judged.result;
  return result.reason + (result.compiler_output.empty() ? "" : ":\n" + result.compiler_output);
}

}  // namespace

// The reference replaces tasks that cannot be compiled, so that the rest can be seen. A figure that
// needs such a task says so instead.
Boxed build_submission(const std::string& submission, const std::string& parts,
                       const std::vector<std::string>& only) {
  const build::Config config = recorded(worker_config(parts));
  GradeRequest request;
  std::optional<intake::TakenIn> taken;
  if (!submission.empty()) request.submission = taken.emplace(config, submission).folder();
  request.isolation = sandbox::probe_isolation(config.root, config.work);
  const build::Builder builder(config, request.isolation.tier, kCompileSeconds);
  std::vector<Judged> judged;
  for (const build::TaskConfig& task : config.tasks) {
    if (submission.empty()) break;
    if (only.empty() || std::ranges::count(only, task.slug) > 0)
      judged.push_back(not_judged(config, task));
  }
  if (!judged.empty()) compile_all(builder, request, judged);
  Boxed boxed;
  for (Judged& each : judged) {
    each.right_alone = each.object.ok();  // link_together() leaves out other tasks
    boxed.hash[each.config->slug] = base::sha256(each.content);
    if (!each.object.ok() && !only.empty())
      throw pt::Error(each.config->slug + " " + why_not(each));
    if (!each.object.ok()) boxed.unusable[each.config->slug] = why_not(each);
  }
  const build::Built worker = link_together(config, builder, judged, Elsewhere::reference);
  if (!worker.ok()) throw pt::Error("it does not link: " + worker.error);
  std::string framework;
  for (const auto* objects : {&config.framework, &config.radiance}) {
    for (const std::string& object : *objects) framework += base::stamp(object);
  }
  boxed.hash["framework"] = base::sha256(framework);
  boxed.worker = worker.path;
  boxed.tier = std::string(1, letter(request.isolation.tier));
  return boxed;
}

void write_boxed(const Boxed& boxed, const std::string& file) {
  pt::write_file(file, nlohmann::json(boxed).dump());
}

Boxed read_boxed(const std::string& file) {
  return nlohmann::json::parse(pt::read_file(file, kMaxJson));
}

void open_worker(const Boxed& boxed, std::chrono::milliseconds call_limit) {
  wire::SessionSettings settings;
  settings.task = "the write-up";
  settings.program = boxed.worker;
  settings.tier = sandbox::tier_of(boxed.tier);
  settings.answers = false;
  settings.give_up = [](results::Cause, const std::string& text) { throw SubmissionFailed(text); };
  settings.call_limit = call_limit;
  settings.total_limit = kTotalLimit;
  settings.max_timeouts = 1;
  settings.max_failures = 1;
  const auto [place, is_new] = opened.try_emplace(boxed.worker);
  open_now = &place->second;
  if (!is_new) return wire::use_session(place->second.session);
  place->second.session = wire::open_session(settings);
  for (const auto& [task, reason] : boxed.unusable) place->second.does_not_compile.insert(task);
}

// A call takes some milliseconds, as the scene goes with it.
const double kQuick = 0.3;

CostedRows costed_rows(const pt::View& view, const pt::RowsRequest& request) {
  const auto seconds = [] {  // of this process and the worker
    return std::chrono::duration<double>(process::time_of_tree(getpid()).running).count();
  };
  const double start = seconds();
  const std::int64_t before = rays_so_far();
  pt::PictureRows rows = wire::worker_rows(view, request);
  return {std::move(rows), seconds() - start, rays_so_far() - before};
}

// With the engine `task` the worker builds its own tree. One row shows whether there is one.
void give_tracer(pt::Scene& scene, const pt::View& view, pt::Engine engine) {
  scene.tracer = pt::Tracer(engine, scene.primitives);
  if (engine != pt::Engine::task) return;
  wire::worker_rows(view, {view.height / 2, 1, 1, {}, 0, {}, {}});
  const auto& todo = wire::session().record().todo;
  for (const std::string_view task : pt::kTreeTasks) {
    if (todo.contains(std::string(task)))
      scene.tracer = pt::Tracer(pt::Engine::linear, scene.primitives);
  }
}

std::vector<std::string> unwritten_tasks() {
  std::set<std::string> tasks = wire::session().record().todo;
  tasks.insert(open_now->does_not_compile.begin(), open_now->does_not_compile.end());
  return {tasks.begin(), tasks.end()};
}

}  // namespace measure
