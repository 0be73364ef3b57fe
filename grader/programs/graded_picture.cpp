// graded_picture: judges one recipe, rendered by a worker. Trusted: no line of a submission runs in
// here. Writes its findings as a results.json with this one picture, and the picture next to it.
// The exit status is 0 if the picture is right, 1 if not, 2 if nothing could be judged.
#include "grader/pictures/recipes/judge_recipe.h"
#include "grader/results/json.h"
#include "grader/service/process/spawn.h"
#include "grader/service/wire/session.h"
#include "grader/service/wire/worker_rows.h"
#include "grader/tasks.h"
#include "pt/command_line.h"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <filesystem>

#include <CLI/CLI.hpp>

namespace {

using namespace grader;

struct Options {
  wire::SessionSettings session;
  pictures::SeedSource source;
  std::string recipes, goldens, recipe;
  std::string report;
  int rounds = 3;
  int call_limit = 10000;
  std::string tier = "C";
};

// The wide engine does not call the tasks of parts 1 and 2.
pt::Engine engine_for(const std::string& slug) {
  return std::ranges::count(tracing_tasks(), slug) > 0 ? pt::Engine::task : pt::Engine::wide;
}

// This program renders one scene.
pt::PictureRows rows_of_the_scene(const pt::View& view, const pt::RowsRequest& request) {
  wire::session().keep(view.scene);
  return wire::worker_rows(view, request);
}

int run(const Options& options) {
  const std::vector<pictures::Recipe> recipes = pictures::load_recipes(options.recipes);
  const pictures::Recipe& recipe = pictures::find(recipes, options.recipe);
  const std::string golden = options.goldens + "/" + recipe.name;
  const std::string beside = std::filesystem::path(options.report).replace_extension();
  wire::open_session(options.session);
  results::PictureResult result = pictures::judge_recipe(
      recipe, {rows_of_the_scene, engine_for(options.session.task), options.source, options.rounds},
      {golden + ".exr", golden + "_rates.json", beside + ".exr", beside + ".evidence.exr",
       beside + ".csv", beside + ".usual.csv"});
  result.integrated = options.session.integrated;
  results::Results results;
  results.complete = true;
  results.tasks.emplace_back().slug = options.session.task;
  results.tasks[0].state = result.state;
  results.tasks[0].printed = wire::session().record().printed;
  results.tasks[0].pictures.push_back(result);
  results::write_json(results, options.report);
  return result.state == results::State::pass ? 0 : 1;
}

void add_options(CLI::App& app, Options& options) {
  app.add_option("--worker", options.session.program, "the worker program")
      ->required()
      ->check(CLI::ExistingFile);
  app.add_option("--task", options.session.task, "the slug of the task that is judged")->required();
  app.add_option("--recipes", options.recipes, "recipes.json")->required();
  app.add_option("--goldens", options.goldens, "the folder of the goldens")->required();
  app.add_option("--recipe", options.recipe, "the recipe's name")->required();
  app.add_option("--report", options.report, "where to write the findings")->required();
  app.add_option("--content", options.source.content, "a hash of the judged files");
  app.add_option("--seed", options.source.seed, "the seed of the run");
  app.add_flag("--integrated", options.session.integrated, "the worker runs all tasks");
  app.add_option("--rounds", options.rounds, "rounds at most")->check(CLI::Range(1, 3));
  app.add_option("--call-limit", options.call_limit, "milliseconds that a few rows may take")
      ->check(CLI::PositiveNumber);
  app.add_option("--isolation", options.tier, "the tier of the worker's box: A, B or C");
}

}  // namespace

int main(int argc, char** argv) {
  process::hide_process();
  std::signal(SIGPIPE, SIG_IGN);
  Options options;
  CLI::App app{"Judges a picture that a worker renders"};
  add_options(app, options);
  return pt::run_command_line(app, argc, argv, [&] {
    options.session.program = std::filesystem::absolute(options.session.program);
    options.session.tier = sandbox::tier_of(options.tier);
    options.session.answers = false;
    options.session.give_up = [](results::Cause cause, const std::string& text) {
      throw pictures::NoPicture{cause, text};
    };
    options.session.call_limit = std::chrono::milliseconds(options.call_limit);
    options.session.max_timeouts = 1;
    // A task that is wrong already gets less time.
    options.session.total_limit = (options.rounds > 1 ? 9 : 3) * options.session.call_limit;
    return run(options);
  });
}
