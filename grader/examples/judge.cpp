#include "grader/examples/judge.h"

#include "grader/base/parallel.h"

#include <algorithm>
#include <optional>

namespace grader::examples {

namespace {

using Kind = Outcome::Kind;

// Two runs of each solution, with the same examples.
struct Twice {
  Run first, second;

  bool is_steady(std::size_t example) const {
    return first.outcomes[example].kind == second.outcomes[example].kind;
  }
};

std::vector<Twice> run_all(const Program& program, const std::vector<std::size_t>& numbers,
                           const std::vector<std::size_t>& only, std::size_t count, int threads) {
  std::vector<Twice> all(numbers.size());
  base::for_each(2 * numbers.size(), threads, [&](std::size_t i) {
    Run run = run_examples(program, numbers[i / 2], only);
    run.outcomes.resize(count);
    (i % 2 == 0 ? all[i / 2].first : all[i / 2].second) = std::move(run);
  });
  return all;
}

// The first of these examples that the solution fails, and fails again when it runs alone. So a count depends neither on chance nor
// on the time that the examples before it took.
std::optional<std::size_t> first_that_catches(const Program& program, std::size_t solution,
                                              std::vector<std::size_t> examples) {
  const auto fails = [](const Run& run, std::size_t i) {
    return i < run.outcomes.size() && run.outcomes[i].is_known() && !run.outcomes[i].holds();
  };
  while (!examples.empty()) {
    const Run run = run_examples(program, solution, examples, true);
    const auto at = std::ranges::find_if(examples, [&](std::size_t i) { return fails(run, i); });
    if (at == examples.end()) break;
    const std::size_t found = *at;
    if (fails(run_examples(program, solution, std::vector{found}), found)) return found;
    examples.erase(examples.begin(), at + 1);
  }
  return std::nullopt;
}

bool ends_the_program(const Outcome& outcome) {
  return outcome.kind == Kind::ends || outcome.kind == Kind::too_long;
}

// `others`: the runs of all right solutions.
Judged judge_example(std::size_t i, const std::string& name, const Outcome& first,
                     const std::vector<Twice>& others) {
  Judged judged{name, Verdict::wrong, first.words, static_cast<int>(others.size())};
  if (ends_the_program(first)) return judged;
  judged.against = 0;
  for (const Twice& other : others) {
    const Outcome& outcome = other.first.outcomes[i];
    if (outcome.holds()) continue;
    if (judged.against++ == 0) judged.words = outcome.words;
  }
  const bool steady =
      std::ranges::all_of(others, [&](const Twice& other) { return other.is_steady(i); });
  const auto all = static_cast<int>(others.size());
  if (first.holds() && first.checks == 0)
    judged.verdict = Verdict::empty;
  else if (!steady)
    judged.verdict = Verdict::unsteady;
  else if (judged.against == 0)
    judged.verdict = Verdict::valid;
  else
    judged.verdict = judged.against == all ? Verdict::wrong : Verdict::too_strict;
  return judged;
}

}  // namespace

std::vector<std::size_t> Verdicts::valid() const {
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < examples.size(); ++i) {
    if (examples[i].verdict == Verdict::valid) all.push_back(i);
  }
  return all;
}

Verdicts judge(const Program& program, const std::vector<mistakes::Solution>& solutions,
               int threads, std::optional<std::size_t> only_mistake) {
  std::vector<std::size_t> rights, wrongs;
  Verdicts verdicts;
  for (std::size_t i = 0; i < solutions.size(); ++i) {
    if (solutions[i].is_right()) {
      rights.push_back(i);
    } else if (only_mistake.value_or(i) == i) {
      wrongs.push_back(i);
      verdicts.mistakes.push_back(solutions[i]);
    }
  }
  verdicts.rights = static_cast<int>(rights.size());
  // An example that ends the program, or never ends, runs once.
  const Run first = run_examples(program, rights.at(0));
  verdicts.fault = first.fault;
  if (first.names.empty()) return verdicts;
  std::vector<std::size_t> plain;
  for (std::size_t i = 0; i < first.outcomes.size(); ++i) {
    if (!ends_the_program(first.outcomes[i])) plain.push_back(i);
  }
  const std::size_t count = first.outcomes.size();
  const std::vector<Twice> right = run_all(program, rights, plain, count, threads);
  for (std::size_t i = 0; i < count; ++i)
    verdicts.examples.push_back(judge_example(i, first.names[i], first.outcomes[i], right));
  const std::vector<std::size_t> valid = verdicts.valid();
  verdicts.caught.resize(wrongs.size());
  if (valid.empty()) return verdicts;
  base::for_each(wrongs.size(), threads, [&](std::size_t m) {
    verdicts.caught[m] = first_that_catches(program, wrongs[m], valid);
  });
  return verdicts;
}

}  // namespace grader::examples
