#include "grader/check/language/bad_inputs.h"

#include "grader/check/language/choices.h"
#include "grader/check/language/fail.h"
#include "pt/file.h"
#include "pt/sampling/sampler.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>

#include <nlohmann/json.hpp>
#include <rapidcheck.h>

namespace grader::check {

namespace {

using nlohmann::json;
using Clock = std::chrono::steady_clock;

constexpr std::size_t kKept = 12;  // the worst inputs of a search
constexpr int kMaxPerFamily = 2;   // the largest number of these that come from one new input
constexpr std::size_t kMaxFile = std::size_t{1} << 26;
constexpr double kSearchSlice = 1;  // seconds of one search before the next

std::vector<NamedSearch>& kept_searches() {
  static std::vector<NamedSearch> all;
  return all;
}

std::string* shown = nullptr;

// An input: the numbers of our generators, and the seed of RapidCheck's other numbers.
struct Input {
  std::uint64_t seed = 0;
  std::vector<double> numbers;
  // The number of the new input from which it was changed, in one step or many.
  long long family = 0;
  double badness = -1;
  std::string reason;  // the message of a case that failed; else empty
};

void to_json(json& out, const Input& input) {
  out = {
      {"seed", input.seed},       {"numbers", input.numbers},           {"family", input.family},
      {"badness", input.badness}, {"broken", input.badness >= kBroken}, {"reason", input.reason}};
}
void from_json(const json& in, Input& input) {
  in.at("seed").get_to(input.seed);
  in.at("numbers").get_to(input.numbers);
  input.family = in.value("family", -1LL);  // an older file has none
}

// Stops the use of a list of choices, however a case ends.
struct Choosing {
  explicit Choosing(Choices& choices) { choose_from(&choices); }
  ~Choosing() { choose_from(nullptr); }
  Choosing(const Choosing&) = delete;
  Choosing& operator=(const Choosing&) = delete;
};

// The error of the task's answer. The input may use fewer or more numbers than it had.
void try_input(const BadInputs& search, Input& input) {
  Choices choices{input.numbers, 0};
  const Choosing choosing(choices);
  input.reason.clear();
  try {
    const auto generator = rc::gen::exec(search.badness);
    input.badness = generator(rc::Random(input.seed), rc::kNominalSize).value();
    if (!std::isfinite(input.badness)) input.badness = kBroken;
  } catch (const CaseFailed& failed) {
    input.badness = kBroken;
    input.reason = failed.failure.got;
  }
  choices.numbers.resize(choices.taken);
  input.numbers = std::move(choices.numbers);
}

// Changes a number in [0, 1): to a new number, to an end, or by a step of any size.
double changed(double number, pt::Sampler& random) {
  const double kind = random.next_1d();
  if (kind < 0.15) return random.next_1d();
  if (kind < 0.2) return random.next_1d() < 0.5 ? 0 : 1 - 0x1p-53;
  const double step = std::pow(2, -50 * random.next_1d()) * (2 * random.next_1d() - 1);
  return std::clamp(number + step, 0.0, 1 - 0x1p-53);
}

class Searching {
 public:
  Searching(const NamedSearch& named, std::uint64_t seed, const json& before)
      : named_(named), random_(seed + std::hash<std::string>{}(named.name)) {
    if (before.is_null()) return;
    before.at("tried").get_to(tried_);
    before.at("seconds").get_to(seconds_);
    // The code may have changed since then.
    random_ = pt::Sampler(seed + static_cast<std::uint64_t>(tried_));
    for (const json& input : before.at("worst")) again_.push_back(input.get<Input>());
  }

  void run(double seconds) {
    const Clock::time_point start = Clock::now();
    for (Input& input : again_) keep(input);
    again_.clear();
    do {
      for (int i = 0; i < 100; ++i) {
        Input input = next();
        keep(input);
        ++tried_;
      }
    } while (passed(start) < seconds);
    seconds_ += passed(start);
  }

  json record() const {
    json out{
        {"name", named_.name}, {"title", named_.search.title}, {"measure", named_.search.measure},
        {"tried", tried_},     {"seconds", seconds_},          {"worst", json::array()}};
    for (Input input : worst_) {
      std::string text;
      shown = &text;
      try_input(named_.search, input);
      shown = nullptr;
      json entry = input;
      entry["input"] = text;
      out["worst"].push_back(entry);
    }
    return out;
  }

 private:
  static double passed(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
  }

  std::uint64_t new_seed() { return static_cast<std::uint64_t>(random_.next_1d() * 0x1p53); }

  // A quarter of all inputs is new; the others are changes of one of the worst.
  Input next() {
    if (worst_.empty() || random_.next_1d() < 0.25) return {new_seed(), {}, tried_, -1, ""};
    const auto any = [&](std::size_t size) {
      return std::min(static_cast<std::size_t>(random_.next_1d() * static_cast<double>(size)),
                      size - 1);
    };
    Input input = worst_[any(worst_.size())];
    if (random_.next_1d() < 0.1 || input.numbers.empty()) input.seed = new_seed();
    for (int changes = 1 + static_cast<int>(any(3)); changes > 0 && !input.numbers.empty();
         --changes) {
      double& number = input.numbers[any(input.numbers.size())];
      number = changed(number, random_);
    }
    return input;
  }

  // Keeps only one of several equally bad inputs, and few of a family, so that not all inputs are
  // copies of the worst with other last digits.
  void keep(Input& input) {
    try_input(named_.search, input);
    const auto same = [&](const Input& other) { return other.badness == input.badness; };
    if (std::ranges::any_of(worst_, same)) return;
    worst_.push_back(input);
    std::ranges::sort(worst_, [](const Input& a, const Input& b) { return a.badness > b.badness; });
    const auto related = [&](const Input& other) { return other.family == input.family; };
    if (std::ranges::count_if(worst_, related) > kMaxPerFamily) {
      worst_.erase(std::find_if(worst_.rbegin(), worst_.rend(), related).base() - 1);
    }
    if (worst_.size() > kKept) worst_.pop_back();
  }

  const NamedSearch& named_;
  pt::Sampler random_;
  std::vector<Input> worst_, again_;
  long long tried_ = 0;
  double seconds_ = 0;
};

// The record of a search by an earlier run.
json before_of(const std::string& file, const std::string& name) {
  if (!std::filesystem::exists(file)) return nullptr;
  const json all = json::parse(pt::read_file(file, kMaxFile));
  for (const json& one : all) {
    if (one.at("name") == name) return one;
  }
  return nullptr;
}

}  // namespace

void show_input(const std::function<std::string()>& text) {
  if (shown != nullptr) *shown = text();
}

const std::vector<NamedSearch>& searches() { return kept_searches(); }

bool keep_search(const char* name, BadInputs (*make)()) {
  kept_searches().push_back({name, make()});
  return true;
}

void run_searches(const SearchSettings& settings) {
  std::vector<Searching> all;
  for (const NamedSearch& named : searches()) {
    all.emplace_back(named, settings.seed, before_of(settings.file, named.name));
  }
  const double each = settings.seconds / static_cast<double>(all.size());
  const int turns = std::max(1, static_cast<int>(std::lround(each / kSearchSlice)));
  for (int turn = 0; turn < turns; ++turn) {
    json out = json::array();
    for (Searching& searching : all) {
      settings.begin();
      searching.run(each / turns);
      settings.begin();
      out.push_back(searching.record());
    }
    pt::write_file(settings.file, out.dump(1) + "\n");
    if (settings.progress) settings.progress((turn + 1.0) / turns);
  }
}

}  // namespace grader::check
