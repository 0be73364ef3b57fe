// writeup: plans the figures of the write-up, makes what is missing or out of date, and writes the
// pages. ./run writeup builds what it needs and starts it.
#include "grader/base/files.h"
#include "grader/base/sha256.h"
#include "grader/service/process/run_command.h"
#include "grader/tasks.h"
#include "measure/charts/labels.h"
#include "pt/end_of_program.h"
#include "pt/error.h"
#include "pt/printable.h"
#include "writeup/code.h"
#include "writeup/handbook.h"
#include "writeup/make_site.h"
#include "writeup/options.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <set>
#include <sstream>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

namespace writeup {
namespace {

// Programs of the grading build, which compile and run tasks in their own boxes. The functions
// return nothing if the programs have not been built, or their folder is not named.

// The program that measures curves. Its hash has everything that the curves of a task depend on. If
// the write-up is not about the reference, the curves have a line for its code.
std::optional<Code> code_of_stability(const Options& options) {
  if (options.stability.empty() || !std::filesystem::exists(options.stability)) return {};
  Code code;
  code.command = {options.stability};
  if (is_of_submission(options)) {
    code.command.insert(code.command.end(), {"--submission", options.submissions[0]});
  } else if (options.from.find("student") != std::string::npos) {
    code.command.insert(code.command.end(), {"--submission", "student"});
  }
  std::vector<std::string> words = code.command;
  words.push_back("--keys");
  const auto result = grader::process::run_command(
      {words, {"PATH=/usr/bin:/bin", "LANG=C.UTF-8"}, {}, "", {}}, std::chrono::minutes(1));
  if (!result.ok()) throw pt::Error(options.stability + ": " + result.output);
  std::istringstream lines(result.output);
  for (std::string task, hash; lines >> task >> hash;) code.hash[task] = hash;
  return code;
}

// The program that times the right solutions of the tree. `code` is the reference's.
std::optional<Code> code_of_measure(const Options& options, const Code& code) {
  if (options.measure.empty() || !std::filesystem::exists(options.measure)) return {};
  std::string text = grader::base::stamp(options.measure);
  for (const auto& [task, hash] : code.hash) text += task + hash;
  return Code{{options.measure}, {{"framework", grader::base::sha256(text)}}, {}};
}

namespace fs = std::filesystem;

// Only one process at a time may write to the renders and take the time of code. Another one waits,
// whichever folder its pages go to.
void lock(const fs::path& work) {
  fs::create_directories(work);
  const int file = open((work / "lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
  if (file >= 0 && flock(file, LOCK_EX | LOCK_NB) == 0) return;
  fmt::print(stderr, "another ./run writeup is running: this one waits until it has ended\n");
  if (file < 0 || flock(file, LOCK_EX) != 0) {
    throw pt::Error("the folder of renders cannot be locked: " + work.string());
  }
}

bool traces_with_reference(const std::string& mixture) {
  if (!mixture.starts_with("reference")) return false;
  return std::ranges::none_of(grader::tracing_tasks(), [&](const std::string& task) {
    return mixture.find(task + "=") != std::string::npos;
  });
}

// The wrong solutions that the pictures of the catalogue are rendered with, and the reference.
std::set<std::string> mistakes_in(const Catalogue& catalogue) {
  std::set<std::string> names;
  for (const Figure& figure : catalogue.figures) {
    for (const Picture& picture : figure.pictures) names.insert(picture.mistake);
    for (const Picture& golden : figure.goldens) names.insert(golden.mistake);
  }
  names.erase("");
  return names;
}

// The program that writes what the paths of a pixel did.
std::optional<Code> code_of_view(const Options& options, const Code& chosen,
                                 const std::vector<const Figure*>& figures) {
  if (!fs::exists(options.view) || !fs::exists(options.view_worker)) return {};
  if (is_of_submission(options)) {
    const bool is_wanted = std::ranges::any_of(figures, [](const Figure* figure) {
      return figure->kind == "path" || figure->kind == "ray";
    });
    return view_of_submission(options, chosen, is_wanted);
  }
  Code code = code_of_program(options.view_worker);
  code.command = {options.view, "--worker", options.view_worker};
  return code;
}

Codes read_codes(const Options& options, const Catalogue& catalogue,
                 const std::vector<const Figure*>& figures) {
  Codes codes;
  const bool is_submission = is_of_submission(options);
  const std::vector<std::string> labels = measure::labels_of(options.submissions);
  codes.chosen = is_submission ? code_of_submission(options, options.submissions[0], labels[0])
                               : code_of_program(options.renderer);
  codes.reference_rays = !is_submission && traces_with_reference(options.from);
  if (!options.accuracy.empty()) {
    codes.accuracy = is_submission ? accuracy_of_submission(options, codes.chosen, labels[0])
                                   : code_of_program(options.accuracy);
  }
  for (std::size_t i = 0; i < labels.size() && !is_submission; ++i) {
    codes.others[labels[i]] = code_of_submission(options, options.submissions[i], labels[i]);
  }
  if (codes.accuracy && !codes.others.empty()) {
    codes.several = accuracy_of_several(options, codes.others);
    for (const auto& [task, hash] : codes.chosen.hash) codes.several->hash[task] += hash;
  }
  // Errors of other code are measured against the reference, if its program is there.
  const bool is_reference = !is_submission && options.from == "reference";
  if (codes.accuracy && !is_reference) {
    const fs::path program = fs::path(options.accuracy).parent_path() / "ladder_rung.reference";
    if (fs::exists(program)) {
      codes.accuracy->command.emplace_back("--reference");
      codes.accuracy->hash["framework"] += grader::base::sha256(grader::base::stamp(program));
    }
  }
  codes.stability = code_of_stability(options);
  codes.view = code_of_view(options, codes.chosen, figures);
  // The learners' edition has no right solutions to compare, and of these programs only the reference's.
  if (!options.mistakes.empty()) codes.measure = code_of_measure(options, codes.chosen);
  const fs::path beside = fs::path(options.renderer).parent_path();
  const fs::path folder = options.mistakes.empty() ? beside : fs::path(options.mistakes);
  for (const std::string& wrong : mistakes_in(catalogue)) {
    const fs::path program = folder / ("writeup_render." + wrong);
    if (fs::exists(program)) codes.mistakes[wrong] = code_of_program(program);
  }
  for (const auto& [label, code] : codes.others) codes.mistakes[other_code(label)] = code;
  return codes;
}

// The command for these pages, as a person types it.
std::string as_typed(const Options& options) {
  std::string words = "./run writeup";
  if (options.draft) words += " --quality draft";
  for (const std::string& submission : options.submissions) words += " --submission " + submission;
  if (options.submissions.empty() && options.from != "reference")
    words += " --from " + options.from;
  if (!options.scenes.empty()) words += " --scenes " + options.scenes;
  return words;
}

void print_list(const Plan& plan, const std::vector<const Figure*>& figures) {
  for (const Figure* figure : figures) {
    plan.prepare(*figure);
    fmt::print("{:5} {:17} {:12} {:7.1f} s  {}\n", figure->part, figure->id,
               is_settled(plan, *figure) ? "up to date" : "to be made", plan.seconds(*figure),
               figure->title);
  }
}

void retry(const Plan& plan, const std::vector<const Figure*>& figures) {
  for (const Figure* figure : figures) {
    for (const Unit& unit : plan.units(*figure)) plan.store().forget_failure(unit);
    for (const Measurement& each : plan.measurements(*figure)) plan.measured().forget_failure(each);
  }
}

void write_pdfs(const fs::path& folder) {
  const char* const chromium = "/usr/bin/chromium";
  if (!fs::exists(chromium)) {
    fmt::print("no PDF: there is no Chromium here; print the pages from your browser\n");
    return;
  }
  for (const std::string& page : page_names()) {
    const fs::path pdf = folder / (page + ".pdf");
    const std::vector<std::string> words{chromium,
                                         "--headless",
                                         "--no-sandbox",
                                         "--disable-gpu",
                                         "--no-pdf-header-footer",
                                         "--virtual-time-budget=10000",
                                         "--user-data-dir=" + (folder / ".chromium").string(),
                                         "--print-to-pdf=" + pdf.string(),
                                         "file://" + (folder / (page + ".html")).string()};
    grader::process::run_command(
        {words, {"PATH=/usr/bin:/bin", "HOME=" + folder.string()}, {}, "", {}},
        std::chrono::minutes(2));
    if (!fs::exists(pdf)) fmt::print(stderr, "Chromium did not make {}\n", pdf.string());
  }
  fs::remove_all(folder / ".chromium");
}

// Prints the time that each figure took.
void print_times(const std::vector<const Figure*>& figures,
                 const std::map<std::string, Drawn>& drawn) {
  for (const Figure* figure : figures) {
    const auto found = drawn.find(figure->id);
    if (found == drawn.end()) continue;
    fmt::print("{:17} {:8.1f} s of processor time\n", figure->id, found->second.seconds);
  }
}

// Prints the first problem of each figure. Returns whether there is a problem.
bool report(const std::vector<const Figure*>& figures, const std::map<std::string, Drawn>& drawn) {
  bool failed = false;
  for (const Figure* figure : figures) {
    const auto found = drawn.find(figure->id);
    if (found == drawn.end() || found->second.problems.empty()) continue;
    const std::vector<std::string>& problems = found->second.problems;
    fmt::print("{}: {}\n", figure->id, problems[0]);
    if (problems.size() > 1) fmt::print("  and {} more, on the page\n", problems.size() - 1);
    failed = true;
  }
  return failed;
}

void make_absolute(Options& options) {
  std::vector<std::string*> paths{&options.scenes, &options.out, &options.texts};
  for (std::string& submission : options.submissions) paths.push_back(&submission);
  for (std::string* path : paths) {
    if (!path->empty()) *path = fs::absolute(*path).lexically_normal().string();
  }
  fs::current_path(options.root);
}

// Makes the missing renders, and the pages. Returns whether nothing is missing.
bool make_pages(const Plan& plan, const Catalogue& catalogue,
                const std::vector<const Figure*>& figures, const Options& options,
                const std::string& command) {
  const fs::path work = options.work;
  Site site{catalogue, plan.scenes(), {}, options.draft, command, options.texts, options.by};
  const fs::path out =
      options.out.empty() ? work / (options.draft ? "draft" : "pages") : fs::path(options.out);
  fs::create_directories(out);
  write_pages(site, out);  // finds a wrong name in a text before the long renders
  const bool made = make_missing(plan, figures, options);
  site.figures = draw_figures(plan, catalogue, work / "drawn", out / "figures", options.threads);
  write_pages(site, out);
  if (made) print_times(figures, site.figures);
  if (options.pdf) write_pdfs(fs::absolute(out));
  const bool failed = report(figures, site.figures);
  fmt::print("{}\n", pt::printable((out / "index.html").string()));
  return !failed;
}

bool make_handbook(const Plan& plan, const Catalogue& catalogue,
                   const std::vector<const Figure*>& figures, const Options& options) {
  if (options.mistakes.empty()) {
    throw pt::Error("the handbook's pictures need the reference, which this edition does not have");
  }
  const fs::path folder = options.out.empty() ? "." : options.out;
  make_missing(plan, figures, options);
  const Problems problems = options.check ? check_handbook(plan, catalogue, figures, folder)
                                          : write_handbook(plan, figures, folder);
  for (const std::string& problem : problems) fmt::print("{}\n", pt::printable(problem));
  return problems.empty();
}

int run(Options options) {
  const std::string command = as_typed(options);
  make_absolute(options);
  const fs::path work = options.work;
  Catalogue catalogue =
      read_catalogue(options.handbook ? "writeup/handbook.json" : "writeup/figures.json");
  if (options.submissions.size() > 1) {
    add_codes(catalogue, measure::labels_of(options.submissions));
  }
  const std::vector<const Figure*> figures = figures_meant(catalogue, options.what);
  if (!options.list) lock(work);
  const Codes codes = read_codes(options, catalogue, figures);
  const Scenes scenes(catalogue, options.scenes, work / "scenes", options.generate, options.draft);
  const Store store(work / "renders");
  const Measurements measured(work / "measured", store);
  const Plan plan(catalogue, codes, scenes, store, measured,
                  options.draft ? Quality::draft : Quality::full);
  if (options.list) {
    print_list(plan, figures);
    return 0;
  }
  for (const Figure* figure : figures) plan.prepare(*figure);
  if (options.retry) retry(plan, figures);
  const bool good = options.handbook ? make_handbook(plan, catalogue, figures, options)
                                     : make_pages(plan, catalogue, figures, options, command);
  return good ? 0 : 1;
}

// Finished work is on disk, and the children end with this process.
void stop(int) {
  const char words[] = "\nstopped; run the same command again to continue\n";
  [[maybe_unused]] const auto written = write(STDERR_FILENO, words, sizeof words - 1);
  _exit(130);
}

}  // namespace
}  // namespace writeup

int main(int argc, char** argv) {
  std::signal(SIGINT, writeup::stop);
  std::signal(SIGTERM, writeup::stop);
  return pt::run_program([&] { return writeup::run(writeup::parse_options(argc, argv)); });
}
