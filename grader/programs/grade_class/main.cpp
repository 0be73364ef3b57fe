// grade_class: grades every submission of a class, or does one step of it: plan, chunk, collect. Exit
// status 0 if all could be judged, 2 if one could not, or nothing could.
#include "grader/intake/tree.h"
#include "grader/programs/grade_class/collect.h"
#include "grader/programs/grade_class/engine.h"
#include "grader/programs/grade_class/one.h"
#include "grader/programs/grade_class/plan.h"
#include "grader/programs/grade_class/teller.h"
#include "grader/programs/status_line.h"
#include "grader/report/worksheet.h"
#include "pt/command_line.h"
#include "pt/error.h"
#include "pt/file.h"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <map>
#include <thread>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <sys/prctl.h>

namespace {

namespace fs = std::filesystem;
using namespace grader;
using namespace grader::programs;

struct Options {
  PlanRequest plan;
  EngineRequest engine;
  std::string config;
  std::vector<std::size_t> numbers;  // of chunks
  bool not_isolated = false;
  bool end_with_parent = false;
};

constexpr const char* kSteps =
    "One step at a time, for other schedulers than --engine knows:\n"
    "  ./run grade-class plan CLASS --out DIR [--chunk-size N] ... [-- OPTIONS of grade]\n"
    "  ./run grade-class chunk DIR NUMBER ...      on any machine that has DIR; in any order\n"
    "  ./run grade-class collect DIR               at any time: tables and pages of what is "
    "judged\n"
    "A class whose folder has one of these names is written ./plan.";

void add_config(CLI::App& app, Options& options) {
  app.add_option("--config", options.config, "what CMake wrote (grade.json)");
}

void describe_plan(CLI::App& app, Options& options) {
  app.add_option("class", options.plan.input,
                 "an export of Canvas, Moodle or Gradescope, or a folder with a folder or "
                 "an archive per submission")
      ->required()
      ->check(CLI::ExistingPath);
  app.add_option("--out", options.plan.out, "where reports go; default: <class>-graded");
  app.add_option("--seed", options.plan.seed,
                 "the seed of all random inputs; default: drawn for the class, and kept");
  app.add_option("--chunk-size", options.plan.chunk_size,
                 "submissions that one process judges; default: as many as give 500 chunks");
  app.add_option(
         "--compare", options.plan.former,
         "reports of an earlier grading: who gains, who loses, and by which promise; judges "
         "with its seed, and only what may have changed")
      ->check(CLI::ExistingDirectory);
  app.add_option("--assignment", options.plan.assignment,
                 "the column in canvas.csv, as Canvas writes it: \"Rays (1234)\"; default: the "
                 "export's name, which Canvas takes for a new one");
  app.add_option("--worksheet", options.plan.worksheet,
                 "the grading worksheet that Moodle exported, to be filled in: moodle.csv is then "
                 "that file with the grades; default: one that holds the submissions only")
      ->check(CLI::ExistingFile);
  app.add_flag("--anonymous", options.plan.anonymous,
               "numbers in place of names; names.csv tells who is who");
  app.add_flag("--not-isolated", options.not_isolated, "go on where nothing isolates submissions");
  add_config(app, options);
  app.prefix_command();
}

void describe_engine(CLI::App& app, Options& options) {
  const std::map<std::string, Engine> engines{
      {"local", Engine::local}, {"parallel", Engine::parallel}, {"slurm", Engine::slurm}};
  app.add_option("--jobs", options.engine.jobs,
                 "submissions at a time; verdicts do not depend on it; default: one per processor")
      ->check(CLI::Range(1, 4096));
  app.add_option("--engine", options.engine.engine,
                 "where: local (this machine), parallel (GNU parallel) or slurm (an array job)")
      ->transform(CLI::Transformer(engines).description("local|parallel|slurm"));
  app.add_option(
         "--engine-option", options.engine.options,
         "a word for parallel or sbatch, as --engine-option=--sshlogin=a,b; may be repeated")
      ->allow_extra_args(false);
}

std::string config_of(const Options& options) {
  return options.config.empty() ? judge::default_config_path()
                                : fs::absolute(options.config).string();
}

std::string programs_of(const Options& options) {
  return fs::path(config_of(options)).parent_path();
}

int processors() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency())); }

// Another machine may share the project's folder, and must not take our judges for ended ones.
std::string work_on(const judge::Config& config, const ClassPlan& plan) {
  return plan.host == host_name() ? "" : config.work + "/on/" + host_name();
}

Judging judging_of(const judge::Config& config, const Options& options, const ClassPlan& plan,
                   const std::string& out, int threads) {
  Judging judging{config, programs_of(options) + "/grade", out};
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

// Reports in the class would be submissions of the next call.
void refuse_inside(const PlanRequest& request) {
  const fs::path input = fs::weakly_canonical(request.input);
  if (fs::is_directory(input) && intake::lies_in(fs::weakly_canonical(request.out), input)) {
    throw pt::Error("the reports in " + request.out + " would lie among the submissions in " +
                    request.input + "; write --out another folder");
  }
}

ClassPlan planned(Options& options, const judge::Config& config,
                  const std::vector<std::string>& words) {
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
  }
  if (!request.worksheet.empty()) {
    request.worksheet = fs::absolute(request.worksheet);
    (void)report::read_worksheet(request.worksheet);  // while nothing is judged yet
  }
  pt::check_target(request.out + "/class.csv");
  ClassPlan plan = make_plan(config, programs_of(options), request);
  const auto is_of_moodle = [](const intake::HandedIn& by) {
    return by.platform == intake::Platform::moodle;
  };
  if (!request.worksheet.empty() && std::ranges::none_of(plan.everybody, is_of_moodle)) {
    throw pt::Error("--worksheet is for what Moodle exports, and nothing in " + request.input +
                    " is named as Moodle names it");
  }
  forget_outcomes(request.out, plan.everybody);
  write_plan(plan, request.out);
  return plan;
}

// Prints the seed of the plan, and the files that it leaves out.
void print_plan(const ClassPlan& plan) {
  fmt::print("seed {} (--seed {} gives the same verdicts again)\n", plan.seed, plan.seed);
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

int grade_all(Options options, const std::vector<std::string>& words) {
  StatusLine line;
  line.show("reading what was handed in", 0);
  const judge::Config config = judge::load_config(config_of(options));
  const ClassPlan plan = planned(options, config, words);
  line.clear();
  print_plan(plan);
  EngineRequest& engine = options.engine;
  if (engine.engine == Engine::local && engine.jobs == 0) engine.jobs = processors();
  const int threads = std::max(1, processors() / std::max(1, engine.jobs));
  const Judging judging = judging_of(config, options, plan, options.plan.out, threads);
  engine.program = {fs::read_symlink("/proc/self/exe"), "chunk", "--config", config_of(options)};
  if (engine.engine == Engine::parallel) engine.program.emplace_back("--end-with-parent");

  Collector collector(config, plan, options.plan.out);
  Teller teller(plan.everybody.size(), line);
  std::vector<bool> known(plan.everybody.size(), false);
  const auto report = [&](std::size_t i, const Graded& graded) {
    teller.tell(graded);
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
  return teller.all_judged() ? 0 : 2;
}

int make_plan_only(Options options, const std::vector<std::string>& words) {
  const ClassPlan plan = planned(options, judge::load_config(config_of(options)), words);
  print_plan(plan);
  fmt::print("{} submissions in {} chunks: ./run grade-class chunk {} NUMBER, from 1 to {}\n",
             plan.everybody.size(), plan.chunks.size(), options.plan.out, plan.chunks.size());
  return 0;
}

int run_chunks(const Options& options) {
  if (options.end_with_parent) prctl(PR_SET_PDEATHSIG, SIGKILL);
  const judge::Config config = judge::load_config(config_of(options));
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
  StatusLine line(StatusLine::Output::none);  // its log has the outcomes
  Teller teller(count, line);
  const int jobs = std::max(1, options.engine.jobs);
  bool complete = true;
  run_chunk(judging_of(config, options, plan, out, 1), plan, all, jobs,
            [&](std::size_t, const Graded& graded) {
              teller.tell(graded);
              complete = complete && !graded.changed;
            });
  return complete ? 0 : 2;  // a problem is an outcome too, which the collector tells
}

int collect(const Options& options) {
  const judge::Config config = judge::load_config(config_of(options));
  const std::string out = fs::absolute(options.plan.out);
  const ClassPlan plan = read_plan(out);
  const Judging judging = judging_of(config, options, plan, out, 1);
  Collector collector(config, plan, out);
  std::size_t judged = 0;
  for (std::size_t i = 0; i < plan.everybody.size(); ++i) {
    const Graded graded = graded_before(judging, plan.everybody[i]);
    judged += graded.problem.empty() ? 1 : 0;
    collector.add(i, graded);
  }
  fmt::print("{} of {} submissions are judged\n", judged, plan.everybody.size());
  print_files(collector, collector.write());
  return judged == plan.everybody.size() ? 0 : 2;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  const std::string step = argc > 1 ? argv[1] : "";
  const bool is_step = step == "plan" || step == "chunk" || step == "collect";
  CLI::App app{"Grades every submission of a class; options after -- go to grade",
               "./run grade-class" + (is_step ? " " + step : "")};
  if (is_step) {
    --argc;
    ++argv;
  } else {
    app.footer(kSteps);
    describe_engine(app, options);
  }
  if (step == "chunk" || step == "collect") {
    app.add_option("reports", options.plan.out, "the folder with the plan")
        ->required()
        ->check(CLI::ExistingDirectory);
    add_config(app, options);
  }
  if (step == "chunk") {
    app.add_option("number", options.numbers, "of the chunks, from 1 on")->required();
    app.add_option("--jobs", options.engine.jobs, "submissions at a time; default: 1")
        ->check(CLI::Range(1, 4096));
    app.add_flag("--end-with-parent", options.end_with_parent,
                 "for engines: it ends when the process that started it does");
    return pt::run_command_line(app, argc, argv, [&] { return run_chunks(options); });
  }
  if (step == "collect") {
    return pt::run_command_line(app, argc, argv, [&] { return collect(options); });
  }
  describe_plan(app, options);
  return pt::run_command_line(app, argc, argv, [&] {
    return is_step ? make_plan_only(options, app.remaining()) : grade_all(options, app.remaining());
  });
}
