// grade_class: grades every submission of a class, or does one step of that: plan, chunk, collect.
// The exit status is 0 if every submission could be judged, and no file that may be work is
// nobody's; else 2.
#include "grader/report/status_line.h"
#include "grader/service/classes/collect.h"
#include "grader/service/classes/engine.h"
#include "grader/service/classes/one.h"
#include "grader/service/classes/options.h"
#include "grader/service/classes/outcome_printer.h"
#include "grader/service/classes/plan.h"
#include "grader/service/intake/tree.h"
#include "grader/service/judging/grade.h"
#include "grader/service/platforms/worksheet.h"
#include "pt/command_line.h"
#include "pt/error.h"
#include "pt/file.h"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <thread>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <sys/prctl.h>

namespace {

namespace fs = std::filesystem;
using namespace grader;
using namespace grader::classes;

std::string config_of(const ClassOptions& options) {
  return options.config.empty() ? build::default_config_path()
                                : fs::absolute(options.config).string();
}

std::string programs_of(const ClassOptions& options) {
  return fs::path(config_of(options)).parent_path();
}

int processors() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency())); }

// Another machine that shares the project's folder must not think that our judges have ended.
std::string work_on(const build::Config& config, const ClassPlan& plan) {
  return plan.host == host_name() ? "" : config.work + "/on/" + host_name();
}

Judging judging_of(const build::Config& config, const ClassOptions& options, const ClassPlan& plan,
                   const std::string& out, int threads) {
  Judging judging{config, programs_of(options) + "/grade", out, plan.id};
  judging.former = plan.former;
  for (std::size_t i = 0; i < plan.former_names.size(); ++i) {
    const std::string& former = plan.former_names[i];
    if (!former.empty()) judging.former_names[plan.everybody[i].name] = former;
  }
  judging.anonymous = !plan.real_names.empty();
  judging.words = plan.words;
  judging.seed = plan.seed;
  judging.threads = threads;
  judging.work = work_on(config, plan);
  return judging;
}

// The next call would take reports inside the class for submissions.
void refuse_inside(const PlanRequest& request) {
  const fs::path input = fs::weakly_canonical(request.input);
  if (fs::is_directory(input) && intake::lies_in(fs::weakly_canonical(request.out), input)) {
    throw pt::Error("the reports in " + request.out + " would lie among the submissions in " +
                    request.input + "; write --out another folder");
  }
}

ClassPlan planned(ClassOptions& options, const build::Config& config,
                  const std::vector<std::string>& words, report::StatusLine& line) {
  line.show("reading what was handed in", 0);
  PlanRequest& request = options.plan;
  request.words = words;
  std::erase(request.words, "--");
  for (const std::string& word : request.words) {
    if (word.starts_with("--seed")) throw pt::Error("write --seed before --, not after it");
  }
  while (request.input.size() > 1 && request.input.back() == '/') request.input.pop_back();
  if (request.out.empty()) request.out = request.input + "-graded";
  request.must_isolate = !options.not_isolated;
  if (request.must_isolate) request.words.emplace_back("--require-isolation");
  refuse_inside(request);
  fs::create_directories(request.out);
  request.out = fs::absolute(request.out);
  if (!request.former.empty()) {
    request.former = fs::absolute(request.former);
    if (fs::equivalent(request.former, request.out)) {
      throw pt::Error("the reports in " + request.out +
                      " cannot be compared with themselves; write --out another folder");
    }
    if (!fs::exists(request.former + "/plan.json")) {
      throw pt::Error(request.former +
                      " has no grading of a class; --compare takes the folder that --out named");
    }
  }
  if (!request.worksheet.empty()) {
    request.worksheet = fs::absolute(request.worksheet);
    (void)platforms::read_worksheet(request.worksheet);  // checked before anything is judged
  }
  for (std::optional<std::string>* file : {&request.rules.roster, &request.rules.overrides}) {
    if (*file && !(*file)->empty()) **file = fs::absolute(**file);
  }
  judging::check_points_and_goldens(config);  // else everybody's report would say it
  pt::check_target(request.out + "/class.csv");
  ClassPlan plan =
      make_plan(config, programs_of(options), request, [&](std::size_t done, std::size_t all) {
        line.show(fmt::format("unpacking: {} of {} submissions", done, all),
                  static_cast<double>(done) / static_cast<double>(std::max<std::size_t>(all, 1)));
      });
  const auto is_of_moodle = [](const intake::HandedIn& by) {
    return by.platform == intake::Platform::moodle;
  };
  if (!request.worksheet.empty() && std::ranges::none_of(plan.everybody, is_of_moodle)) {
    throw pt::Error("--worksheet is for what Moodle exports, and nothing in " + request.input +
                    " is named as Moodle names it");
  }
  forget_outcomes(request.out, plan.everybody);
  write_plan(plan, request.out);
  line.clear();
  return plan;
}

void print_seed(const ClassPlan& plan) {
  fmt::print("seed {} (--seed {} gives the same verdicts again)\n", plan.seed, plan.seed);
}

void print_rules(const ClassPlan& plan) {
  const std::string rules = sentence_of(plan.rules);
  if (!rules.empty()) fmt::print("{}\n", rules);
  for (const std::string& remark : plan.remarks) fmt::print("{}\n", remark);
}

// Prints the files that the plan leaves out.
void print_unclaimed(const ClassPlan& plan) {
  const std::vector<std::string>& files = plan.unclaimed;
  if (files.empty()) return;
  fmt::print("{} in the class {}: {}\n",
             files.size() == 1 ? "1 file" : fmt::format("{} files", files.size()),
             files.size() == 1 ? "belongs to nobody" : "belong to nobody", some_of(files));
}

void print_files(const Collector& collector, const std::vector<std::string>& files) {
  for (const std::string& remark : collector.remarks()) fmt::print("{}\n", remark);
  for (const std::string& file : files) fmt::print("{}\n", file);
}

int grade_all(ClassOptions options, const std::vector<std::string>& words) {
  report::StatusLine line;
  const build::Config config = build::load_config(config_of(options));
  const ClassPlan plan = planned(options, config, words, line);
  print_seed(plan);
  print_rules(plan);
  print_unclaimed(plan);
  EngineRequest& engine = options.engine;
  if (engine.engine == Engine::local && engine.jobs == 0) engine.jobs = processors();
  const int threads = std::max(1, processors() / std::max(1, engine.jobs));
  const Judging judging = judging_of(config, options, plan, options.plan.out, threads);
  engine.program = {fs::read_symlink("/proc/self/exe"), "chunk", "--config", config_of(options)};
  if (engine.engine == Engine::parallel) engine.program.emplace_back("--end-with-parent");

  Collector collector(config, plan, options.plan.out);
  OutcomePrinter outcomes(plan.everybody.size(), line);
  std::vector<bool> known(plan.everybody.size(), false);
  const auto report = [&](std::size_t i, const Graded& graded) {
    outcomes.print(graded);
    collector.add(i, graded);
    known[i] = true;
  };
  for (std::size_t i = 0; i < plan.everybody.size(); ++i) {
    if (!plan.everybody[i].problem.empty()) report(i, graded_before(judging, plan.everybody[i]));
  }
  run_plan(judging, plan, engine, report);
  for (std::size_t i = 0; i < plan.everybody.size(); ++i) {
    if (!known[i]) report(i, graded_before(judging, plan.everybody[i]));
  }
  line.show("writing tables and pages", 0);
  const std::vector<std::string> files = collector.write();
  line.clear();
  print_files(collector, files);
  return outcomes.all_judged() && !plan.work_is_unclaimed ? 0 : 2;
}

int make_plan_only(ClassOptions options, const std::vector<std::string>& words) {
  report::StatusLine line;
  const ClassPlan plan = planned(options, build::load_config(config_of(options)), words, line);
  print_seed(plan);
  print_rules(plan);
  print_unclaimed(plan);
  fmt::print("{} submissions in {} chunks: ./run grade-class chunk {} NUMBER, from 1 to {}\n",
             plan.everybody.size(), plan.chunks.size(), options.plan.out, plan.chunks.size());
  return 0;
}

int run_chunks(const ClassOptions& options) {
  if (options.end_with_parent) prctl(PR_SET_PDEATHSIG, SIGKILL);
  const build::Config config = build::load_config(config_of(options));
  const std::string out = fs::absolute(options.plan.out);
  const ClassPlan plan = read_plan(out);
  Chunk all;
  for (const std::size_t number : options.numbers) {
    if (number < 1 || number > plan.chunks.size()) {
      throw pt::Error(
          fmt::format("there is no chunk {}; the plan has 1 to {}", number, plan.chunks.size()));
    }
    const Chunk& chunk = plan.chunks[number - 1];
    all.insert(all.end(), chunk.begin(), chunk.end());
  }
  std::size_t count = 0;
  for (const Equal& equal : all) count += equal.size();
  report::StatusLine line(report::StatusLine::Output::none);  // no line: the outcomes go to a log
  OutcomePrinter outcomes(count, line);
  const int jobs = std::max(1, options.engine.jobs);
  bool complete = true;
  run_chunk(judging_of(config, options, plan, out, 1), plan, all, jobs,
            [&](std::size_t, const Graded& graded) {
              outcomes.print(graded);
              complete = complete && !graded.changed;
            });
  return complete ? 0 : 2;  // a problem is an outcome too: the collector reports it
}

int collect(const ClassOptions& options) {
  const build::Config config = build::load_config(config_of(options));
  const std::string out = fs::absolute(options.plan.out);
  const ClassPlan plan = read_plan(out);
  const Judging judging = judging_of(config, options, plan, out, 1);
  Collector collector(config, plan, out);
  std::size_t judged = 0;
  for (std::size_t i = 0; i < plan.everybody.size(); ++i) {
    const Graded graded = graded_before(judging, plan.everybody[i]);
    judged += graded.problem.empty() || graded.by.absent ? 1 : 0;
    collector.add(i, graded);
  }
  print_unclaimed(plan);
  fmt::print("{} of {} submissions are judged\n", judged, plan.everybody.size());
  print_files(collector, collector.write());
  return judged == plan.everybody.size() && !plan.work_is_unclaimed ? 0 : 2;
}

}  // namespace

int main(int argc, char** argv) {
  ClassOptions options;
  const std::string step = argc > 1 ? argv[1] : "";
  const bool is_step = step == "plan" || step == "chunk" || step == "collect";
  CLI::App app{"Grades every submission of a class; options after -- go to grade",
               "./run grade-class" + (is_step ? " " + step : "")};
  if (is_step) {
    --argc;
    ++argv;
  }
  if (step == "chunk") {
    describe_chunk(app, options);
    return pt::run_command_line(app, argc, argv, [&] { return run_chunks(options); });
  }
  if (step == "collect") {
    describe_collect(app, options);
    return pt::run_command_line(app, argc, argv, [&] { return collect(options); });
  }
  if (step == "plan") {
    describe_plan(app, options);
    return pt::run_command_line(app, argc, argv,
                                [&] { return make_plan_only(options, app.remaining()); });
  }
  describe_class(app, options);
  return pt::run_command_line(app, argc, argv, [&] { return grade_all(options, app.remaining()); });
}
