#include "grader/examples/judge.h"

#include "grader/base/parallel.h"

#include <algorithm>

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
               int threads) {
  std::vector<std::size_t> rights, wrongs;
  Verdicts verdicts;
  for (std::size_t i = 0; i < solutions.size(); ++i) {
    (solutions[i].is_right() ? rights : wrongs).push_back(i);
    if (!solutions[i].is_right()) verdicts.mistakes.push_back(solutions[i]);
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
  const std::vector<Twice> wrong = run_all(program, wrongs, valid, count, threads);
  for (std::size_t m = 0; m < wrongs.size(); ++m) {
    for (const std::size_t i : valid) {
      const Outcome& outcome = wrong[m].first.outcomes[i];
      if (outcome.is_known() && !outcome.holds() && wrong[m].is_steady(i))
        verdicts.caught[m].push_back(i);
    }
  }
  return verdicts;
}

}  // namespace grader::examples
