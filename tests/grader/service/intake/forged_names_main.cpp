// forged_names COUNT [SEED]: makes exports of all platforms, until they have COUNT names, in which
// learners call their files what they like, and tests that every other learner's files are read as
// theirs. An upload of one learner never changes another's row. It ran once with ten million names:
//   build/check/tests/forged_names 10000000
#include "grader/service/intake/owner.h"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace {

using grader::intake::Label;
using grader::intake::Labels;

std::mt19937_64& random_numbers() {
  static std::mt19937_64 numbers;
  return numbers;
}

int below(int end) { return static_cast<int>(random_numbers()() % static_cast<unsigned>(end)); }

template <std::size_t n>
std::string any(const std::array<const char*, n>& all) {
  return all[static_cast<std::size_t>(below(static_cast<int>(n)))];
}

constexpr std::array kNames{"ada",  "bob", "bob_7", "7",       "7_8",     "team_12", "o_neil",
                            "bob_", "a",   "a_b",   "s_smith", "j_smith", "smith",   "late"};
constexpr std::array kFiles{"hit_box.cpp", "work.zip",  "1_rays.zip",      "hit_box-1.cpp",
                            "report.pdf",  "3_1_a.cpp", "hit_box (1).cpp", "2027_notes.txt"};
constexpr std::array kDates{"Jan 15, 2027 1005 PM", "15 January, 2027 2205", "2027-01-15 22 05",
                            "15 mai 2027 2205"};
constexpr const char* kAttempt = "2027-01-15-22-05-33";

struct Learner {
  std::string name;
  int id = 0;
};

// The text that the platform writes before a learner's own name of a file. The numbers of Canvas
// are large, as it counts the files of all its courses.
using Platform = std::string (*)(const Learner& learner, int file);
constexpr std::array<Platform, 7> kPlatforms{
    [](const Learner& by, int file) {
      return fmt::format("{}_{}_{}_", by.name, by.id, 100000 + file);
    },
    [](const Learner& by, int file) {
      return fmt::format("{}_LATE_{}_{}_", by.name, by.id, 100000 + file);
    },
    [](const Learner& by, int) {
      std::string name = by.name;
      for (char& c : name) c = c == '_' ? ' ' : c;
      return fmt::format("{}_{}_assignsubmission_file_", name, by.id);
    },
    [](const Learner& by, int file) {
      return fmt::format("{}-7 - {} - {} - ", by.id, by.name,
                         kDates[static_cast<std::size_t>(file) % kDates.size()]);
    },
    [](const Learner& by, int) {
      return fmt::format("HW_1_{}{}_attempt_{}_", by.name, by.id, kAttempt);
    },
    [](const Learner& by, int file) {
      return fmt::format("{}{}@school.edu_{}_", by.name, by.id, 1 + file);
    },
    [](const Learner& by, int file) {
      return fmt::format("{}{}@school.edu_1_box_1_{}_{}_", by.name, by.id, 1 + file, 900 + file);
    }};

// A name that a learner may choose: pieces of every form, with the names and numbers of others.
std::string forged(const std::vector<Learner>& all) {
  std::string name;
  for (int pieces = 1 + below(4); pieces > 0; --pieces) {
    const Learner& other = all[static_cast<std::size_t>(below(static_cast<int>(all.size())))];
    switch (below(9)) {
      case 0:
        name += any(kNames);
        break;
      case 1:
        name += std::to_string(below(2) == 0 ? other.id : below(5000));
        break;
      case 2:
        name += "_";
        break;
      case 3:
        name += any(std::array{"_assignsubmission_file_", "_attempt_", " - ", "LATE_", "anon_aB3xz",
                               "text.html", "\n", "@x.org_", "_"});
        break;
      case 4:
        name += fmt::format("_{}_{}_", other.id, below(5000));
        break;
      case 5:
        name += below(2) == 0 ? kAttempt : any(kDates);
        break;
      default:
        name += kPlatforms[static_cast<std::size_t>(below(kPlatforms.size()))](other, below(9));
        break;
    }
  }
  return name + (below(4) == 0 ? "" : any(kFiles));
}

struct File {
  std::size_t owner;
  std::string before, called;
};

// One export. The first learner forges names, the second has ordinary names, and the others have
// both kinds. Returns the number of names; 0 if somebody else's file is not read as theirs.
std::size_t try_export() {
  const Platform platform = kPlatforms[static_cast<std::size_t>(below(kPlatforms.size()))];
  std::vector<Learner> all;
  std::set<int> ids;
  for (int i = 2 + below(3); i > 0; --i) {
    int id = 1 + below(40);
    while (!ids.insert(id).second) id = 1 + below(40);
    all.push_back({any(kNames), id});
  }
  std::map<std::string, File> files;
  for (std::size_t owner = 0; owner < all.size(); ++owner) {
    for (int i = 1 + below(2); i > 0; --i) {
      const bool plain = owner == 1 || (owner > 1 && below(2) == 0);
      const std::string called = plain ? any(kFiles) : forged(all);
      const std::string before = platform(all[owner], static_cast<int>(files.size()));
      if (!called.empty()) files.try_emplace(before + called, File{owner, before, called});
    }
  }
  std::vector<std::string> names;
  for (const auto& [name, file] : files) names.push_back(name);
  static const auto forms =
      grader::intake::read_name_forms(FIRSTLIGHT_ROOT "/grader/name_forms.csv");
  const Labels labels(names, {}, forms);
  std::map<std::string, std::size_t> keys, numbers;
  for (const auto& [name, file] : files) {
    const std::optional<Label> label = labels.of(name);
    const bool plain = file.owner == 1;
    const bool is_right =
        label && (!plain || (label->before == file.before && label->file == file.called)) &&
        keys.try_emplace(label->key, file.owner).first->second == file.owner &&
        (label->id.empty() ||
         numbers.try_emplace(label->id, file.owner).first->second == file.owner);
    if (is_right) continue;
    fmt::print("'{}' is not read as what it is:", name);
    if (label) fmt::print(" name '{}', ID '{}', file '{}'", label->name, label->id, label->file);
    fmt::print("\n");
    for (const std::string& each : names) fmt::print("  {}\n", each);
    return 0;
  }
  return names.size();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fputs("forged_names COUNT [SEED]\n", stderr);
    return 2;
  }
  random_numbers().seed(argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1);
  const std::size_t count = std::strtoull(argv[1], nullptr, 10);
  for (std::size_t done = 0; done < count;) {
    const std::size_t names = try_export();
    if (names == 0) return 1;
    done += names;
  }
  fmt::print("{} names, and every file is its owner's\n", count);
  return 0;
}
