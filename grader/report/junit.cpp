#include "grader/report/junit.h"

#include "grader/report/terminal.h"
#include "grader/results/presentable.h"
#include "grader/results/summary.h"

#include <fmt/format.h>
#include <tinyxml2.h>

namespace grader::report {

namespace {

// The outcome of a testcase. `element` is empty if it passed.
struct Case {
  std::string name;
  double seconds = 0;
  std::string element;  // "failure", "error", "skipped"
  std::string type;
  std::string message;  // one line
  std::string text;
};

struct Suite {
  std::string name;
  std::string class_name;
  double seconds = 0;
  std::vector<Case> cases;
};

const char* element_of(results::State state) {
  switch (state) {
    case results::State::pass:
      return "";
    case results::State::fail:
    case results::State::too_noisy:
      return "failure";
    case results::State::crash:
    case results::State::timeout:
    case results::State::rejected:
      return "error";
    case results::State::not_attempted:
    case results::State::blocked:
    case results::State::not_judged:
      return "skipped";
  }
  return "error";
}

std::string text_of(const results::TaskResult& task, const std::string& promise) {
  for (const FailureText& each : failure_texts(task, {false, true})) {
    if (each.promise == promise) return each.text;
  }
  return task.reason + "\n" + task.compiler_output;
}

Case promise_case(const results::TaskResult& task, const results::PromiseResult& promise) {
  Case result{promise.name, promise.seconds, "", "", task.reason, ""};
  if (task.state == results::State::not_attempted || task.state == results::State::blocked) {
    result.element = "skipped";
    if (result.message.empty()) result.message = results::words(task.state);
  } else if (!results::is_judged(task, promise)) {
    result.element = "skipped";
    result.message = results::words(task.state);
  } else if (!promise.held && promise.bonus) {
    result.element = "skipped";
    result.message = "a bonus promise that is not kept";
  } else if (!promise.held) {
    const std::string mistake = results::mistake_text(task);
    const bool shown = !promise.failures.empty();
    const std::string cause = shown ? name(promise.failures[0].cause) : "";
    const std::string whole = element_of(task.state);
    result.type = shown ? cause : name(task.state);
    result.element = cause == "wrong" || (!shown && whole != "error") ? "failure" : "error";
    if (shown || task.reason.empty()) result.message = promise.words;
    result.text = text_of(task, promise.name);
    // The text of every promise has the mistake once: a reader of JUnit shows one testcase at a time.
    if (!mistake.empty() && result.text.find(task.mistake.sentence) == std::string::npos) {
      result.text = mistake + "\n" + result.text;
    }
  }
  return result;
}

Case picture_case(const results::TaskResult& task, const results::PictureResult& picture) {
  Case result{"picture " + picture.recipe, picture.seconds, element_of(picture.state),
              name(picture.state),         picture.text,    ""};
  if (result.message.empty()) result.message = results::words(picture.state);
  if (result.element == "failure" || result.element == "error") {
    result.text =
        fmt::format("{}\n{}\n{}\n{}\n", picture.title, picture.text,
                    results::how_to_see(task, picture), results::how_to_look(task.slug, picture));
  }
  return result;
}

Suite suite_of(const results::TaskResult& task) {
  Suite suite{
      task.number + " " + task.slug, task.part + "." + task.slug, results::seconds(task), {}};
  for (const results::PromiseResult& each : task.promises)
    suite.cases.push_back(promise_case(task, each));
  for (const results::PictureResult& each : task.pictures)
    suite.cases.push_back(picture_case(task, each));
  // A fault of the whole task: a file that is missing, or does not compile.
  const std::string expected = element_of(task.state);
  bool said = expected.empty();
  for (const Case& each : suite.cases) {
    said |= !each.element.empty() && (each.element == expected || expected == "failure");
  }
  if (!said || suite.cases.empty()) {
    const std::string message = task.reason.empty() ? results::words(task.state) : task.reason;
    suite.cases.push_back({task.slug, 0, expected, name(task.state), message,
                           expected == "skipped" ? "" : message + "\n" + task.compiler_output});
  }
  return suite;
}

int count(const Suite& suite, const std::string& element) {
  int sum = 0;
  for (const Case& each : suite.cases) sum += each.element == element ? 1 : 0;
  return sum;
}

std::string decimal(double value) { return fmt::format("{:.3f}", value >= 0 ? value : 0.0); }

void print(tinyxml2::XMLPrinter& xml, const Case& each, const std::string& class_name) {
  xml.OpenElement("testcase");
  xml.PushAttribute("name", each.name.c_str());
  xml.PushAttribute("classname", class_name.c_str());
  xml.PushAttribute("time", decimal(each.seconds).c_str());
  if (!each.element.empty()) {
    xml.OpenElement(each.element.c_str());
    xml.PushAttribute("message", each.message.c_str());
    if (each.element != "skipped") {
      xml.PushAttribute("type", each.type.c_str());
      xml.PushText(each.text.c_str());
    }
    xml.CloseElement();
  }
  xml.CloseElement();
}

void print(tinyxml2::XMLPrinter& xml, const Suite& suite) {
  xml.OpenElement("testsuite");
  xml.PushAttribute("name", suite.name.c_str());
  xml.PushAttribute("tests", static_cast<int>(suite.cases.size()));
  xml.PushAttribute("failures", count(suite, "failure"));
  xml.PushAttribute("errors", count(suite, "error"));
  xml.PushAttribute("skipped", count(suite, "skipped"));
  xml.PushAttribute("time", decimal(suite.seconds).c_str());
  for (const Case& each : suite.cases) print(xml, each, suite.class_name);
  xml.CloseElement();
}

}  // namespace

std::string to_junit(const results::Results& raw) {
  const results::Results results = results::presentable(raw);
  std::vector<Suite> suites;
  for (const results::TaskResult& task : results.tasks) suites.push_back(suite_of(task));
  if (!results.complete) {
    suites.push_back(
        {"run", "run", 0, {{"ends", 0, "error", "stopped", results::kStopped, results::kStopped}}});
  }
  int tests = 0, failures = 0, errors = 0;
  for (const Suite& suite : suites) {
    tests += static_cast<int>(suite.cases.size());
    failures += count(suite, "failure");
    errors += count(suite, "error");
  }
  tinyxml2::XMLPrinter xml;
  xml.PushHeader(false, true);
  xml.OpenElement("testsuites");
  xml.PushAttribute("name", results.submission.c_str());
  xml.PushAttribute("tests", tests);
  xml.PushAttribute("failures", failures);
  xml.PushAttribute("errors", errors);
  // The schema that Jenkins holds reports to allows no "skipped" here.
  xml.PushAttribute("time", decimal(results.seconds).c_str());
  for (const Suite& suite : suites) print(xml, suite);
  xml.CloseElement();
  return std::string(xml.CStr()) + "\n";
}

}  // namespace grader::report
