// example_page FOLDER: for tests/grader/report/page.sh. Writes FOLDER/page.html, the page of a run
// that contains everything, and FOLDER/class.html, the page of a class of a thousand.
#include "grader/report/write_reports.h"
#include "grader/service/platforms/class_page.h"
#include "pt/file.h"
#include "tests/grader/report/example_results.h"

#include <random>

namespace {

using namespace grader;

// Keeps about this part of the task's promises and breaks the others.
void weaken(results::TaskResult& task, double part, std::mt19937& random) {
  std::bernoulli_distribution good(part);
  task.points = 0;
  task.max_points = 10;
  for (results::PromiseResult& promise : task.promises) promise.held = good(random);
  for (results::PictureResult& picture : task.pictures) {
    picture.state = good(random) ? results::State::pass : results::State::fail;
  }
  task.state = results::state_of(task);
  if (good(random)) task.state = results::State::pass;
  if (task.state == results::State::pass) task.points = task.max_points;
  if (good(random) && good(random)) task.mistake = {};
}

std::string class_of_a_thousand(const results::Results& example) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> skill(0.3, 1);
  platforms::ClassPage page;
  for (int i = 0; i < 1000; ++i) {
    results::Results results = example;
    const double part = skill(random);
    for (results::TaskResult& task : results.tasks) weaken(task, part, random);
    const std::string name = i == 7 ? kHostile : "learner " + std::to_string(i);
    const std::string problem = i % 50 == 3 ? "'work.zip' cannot be unpacked: " + kHostile : "";
    page.add({name, std::to_string(9000 - i), name + ".html", problem, i % 9 == 0}, results);
  }
  return page.to_html();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const std::string folder = argv[1];
  const results::Results example = example_results(folder);
  report::ReportFiles files;
  files.html = folder + "/page.html";
  report::write_reports(example, files);
  pt::write_file(folder + "/class.html", class_of_a_thousand(example));
  return 0;
}
