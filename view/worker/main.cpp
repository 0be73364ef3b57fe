// view_worker SCENE [--lambertian] [--one-thread]: answers the questions of `view`, which come one per line on descriptor 3, as JSON:
// {"what": "picture", "query": {"w": "480"}}. An answer, on descriptor 4, is a line of JSON, {"size": N, "state": ...} or
// {"error": ...}, and N bytes. It runs the tasks, and may crash or hang; `view` does not.
#include "pt/end_of_program.h"
#include "pt/error.h"
#include "pt/todo_list.h"
#include "view/worker/answer.h"

#include <cstdio>
#include <set>
#include <string_view>

#include <nlohmann/json.hpp>
#include <unistd.h>

namespace {

using nlohmann::json;

constexpr int kQuestions = 3, kAnswers = 4;

void send(const json& head, const std::string& bytes, std::FILE* to) {
  const std::string line = head.dump(-1, ' ', false, json::error_handler_t::replace) + "\n";
  std::fwrite(line.data(), 1, line.size(), to);
  std::fwrite(bytes.data(), 1, bytes.size(), to);
  std::fflush(to);
}

void answer(view::Answers& answers, const std::string& line, std::FILE* to) {
  try {
    const json question = json::parse(line);
    const view::Answer answer =
        answers.answer(question.at("what"), question.at("query").get<view::Query>());
    send({{"size", answer.bytes.size()}, {"state", answer.state}}, answer.bytes, to);
  } catch (const std::exception& error) {
    send({{"size", 0}, {"error", pt::sentence_of(error)}}, "", to);
  }
}

int run(int argc, char** argv) {
  if (argc < 2) throw pt::Error("name a scene: view_worker SCENE.dae");
  std::FILE* const from = fdopen(kQuestions, "r");
  std::FILE* const to = fdopen(kAnswers, "w");
  if (from == nullptr || to == nullptr) throw pt::Error("this program is started by ./run view");
  pt::silence_todo();
  const std::set<std::string_view> options(argv + 2, argv + argc);
  view::Answers answers(argv[1], options.contains("--lambertian"),
                        options.contains("--one-thread"));
  std::string line;
  for (int c = std::fgetc(from); c != EOF; c = std::fgetc(from)) {
    if (c != '\n') {
      line += static_cast<char>(c);
      continue;
    }
    answer(answers, line, to);
    line.clear();
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  return pt::run_program([&] { return run(argc, argv); });
}
