#include "grader/examples/report.h"

#include "grader/base/wrap.h"
#include "pt/file.h"

#include <algorithm>

#include <fmt/format.h>

namespace grader::examples {

namespace {

constexpr std::size_t kWidth = 80;

std::string indented(const std::string& text) {
  std::string all;
  for (const std::string& line : base::wrap(text, kWidth)) all += "    " + line + '\n';
  return all;
}

std::string counted(std::size_t count, const char* one, const char* more) {
  return fmt::format("{} {}", count, count == 1 ? one : more);
}

// The paragraph "Precision: ..." of a contract.
std::string precision_in(const std::string& header) {
  std::string paragraph;
  for (const std::string& line : base::lines_of(header)) {
    const std::string text = line.starts_with("// ") ? line.substr(3) : "";
    if (text.starts_with("Precision:"))
      paragraph = text;
    else if (!paragraph.empty() && text.empty())
      return paragraph;
    else if (!paragraph.empty())
      paragraph += ' ' + text;
  }
  return paragraph;
}

std::string row(const Judged& example, int rights) {
  switch (example.verdict) {
    case Verdict::valid:
      return fmt::format("  valid       {}\n", example.name);
    case Verdict::empty:
      return fmt::format("  empty       {}: it checks nothing yet\n", example.name);
    case Verdict::unsteady:
      return fmt::format(
          "  unsteady    {}: the same function once passes it and once does not. Use no time and "
          "no "
          "random numbers of your own\n",
          example.name);
    case Verdict::too_strict:
      return fmt::format("  too strict  {}: {} of {} right solutions do something else: {}\n",
                         example.name, example.against, rights, example.words);
    default:
      return fmt::format("  wrong       {}: no right solution agrees: {}\n", example.name,
                         example.words);
  }
}

// The contract leaves open how precise an answer is, and whether promises that are a bonus are kept.
std::string open_text(const Texts& texts) {
  std::string text = "\nToo strict: the contract leaves it open.\n" + indented(texts.precision);
  for (const results::Promise& promise : texts.promises) {
    if (promise.bonus)
      text += indented(fmt::format("A right solution need not keep \"{}\".", promise.title));
  }
  return text;
}

// The share of the mistakes that break the promise (of all mistakes if it has no name) and are caught.
Share share_of(const Verdicts& verdicts, const results::Promise& promise, bool ordinary) {
  Share share{promise};
  for (std::size_t m = 0; m < verdicts.mistakes.size(); ++m) {
    const mistakes::Solution& mistake = verdicts.mistakes[m];
    if (mistake.is_ordinary != ordinary ||
        (!promise.name.empty() && mistake.breaks != promise.name))
      continue;
    ++share.all;
    share.caught += verdicts.caught[m] ? 1 : 0;
  }
  return share;
}

std::string promises_text(const Verdicts& verdicts, const Texts& texts) {
  std::string rows, question;
  for (const auto& [promise, caught, all] : shares(verdicts, texts.promises)) {
    rows += fmt::format("  {:48} {:2} of {}\n", promise.title, caught, all);
    if (caught == 0 && question.empty() && !promise.bonus)
      question = fmt::format("\nNo example of yours looks at \"{}\":\n{}", promise.title,
                             indented(report::about(texts.hints[0], promise.name)));
  }
  return rows + question;
}

std::string catch_text(const Verdicts& verdicts, const Texts& texts) {
  const std::size_t valid = verdicts.valid().size();
  if (valid == 0) return "\nNo example is valid yet, so none is tried on wrong solutions.\n";
  const Share bar = share_of(verdicts, {}, true), rare = share_of(verdicts, {}, false);
  const std::string more =
      rare.all == 0 ? ""
                    : fmt::format("\nThey also catch {} of {} that only rare inputs show.\n",
                                  rare.caught, rare.all);
  return fmt::format("\nThe {} of {} wrong solutions{}, by the promise that they break:\n{}{}",
                     valid == 1 ? fmt::format("valid example catches {}", bar.caught)
                                : fmt::format("{} valid examples catch {}", valid, bar.caught),
                     bar.all, rare.all == 0 ? "" : " that ordinary inputs show",
                     promises_text(verdicts, texts), more);
}

}  // namespace

Texts texts_of(const std::string& root, const std::string& slug) {
  const std::string header = pt::read_file(root + "/pt/tasks/" + slug + ".h");
  const std::string hints = root + "/grader/tasks/" + slug + "/hints.md";
  return {slug, results::promises_of(header), report::parse_hints(pt::read_file(hints), hints),
          precision_in(header)};
}

std::vector<Share> shares(const Verdicts& verdicts, const std::vector<results::Promise>& promises) {
  std::vector<Share> all;
  for (const results::Promise& promise : promises) {
    const Share share = share_of(verdicts, promise, true);
    if (share.all > 0) all.push_back(share);
  }
  return all;
}

std::string rows_text(const Verdicts& verdicts) {
  std::string text;
  for (const Judged& example : verdicts.examples) text += row(example, verdicts.rights);
  return text;
}

std::string to_text(const Verdicts& verdicts, const Texts& texts) {
  std::string text =
      fmt::format("{}: {}, held against {} right and {} wrong solutions\n\n", texts.slug,
                  counted(verdicts.examples.size(), "example", "examples"), verdicts.rights,
                  verdicts.mistakes.size()) +
      rows_text(verdicts);
  const bool strict =
      std::ranges::count(verdicts.examples, Verdict::too_strict, &Judged::verdict) > 0;
  return text + (strict ? open_text(texts) : "") + catch_text(verdicts, texts);
}

std::string own_text(const Verdicts& verdicts, const Run& own, const std::string& slug) {
  if (std::ranges::count(own.todo, slug) > 0)
    return fmt::format("\nYour own {} is not written yet.\n", slug);
  std::string rows;
  std::size_t fails = 0;
  const std::vector<std::size_t> valid = verdicts.valid();
  for (const std::size_t i : valid) {
    if (i < own.outcomes.size() && own.outcomes[i].holds()) continue;
    ++fails;
    const std::string words = i < own.outcomes.size() ? own.outcomes[i].words : "";
    rows += fmt::format("  {}{}\n", verdicts.examples[i].name,
                        words.empty() ? ": it did not run" : ": " + words);
  }
  const std::string count = counted(valid.size(), "valid example", "valid examples");
  if (fails == 0) return fmt::format("\nYour own {} passes your {}.\n", slug, count);
  return fmt::format("\nYour own {} fails {} of your {}:\n{}", slug, fails, count, rows);
}

}  // namespace grader::examples
