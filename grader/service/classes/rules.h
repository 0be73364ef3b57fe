#pragma once

#include "grader/service/intake/handed_in.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

// The instructor says who is in a class, until when they hand in, and points by hand.

namespace grader::classes {

struct Rules {
  std::string roster;  // a table with the columns id, name, due, handed_in; may be empty
  std::string
      due;        // a time as in seconds_of; empty: nothing is late but what the platform calls so
  int grace = 0;  // minutes after it that are forgiven
  int penalty = 0;               // percent of the points for each day that has begun
  std::string overrides;         // a table with the columns id, name, points, word; may be empty
  std::string attempt = "last";  // or "first": which counts of several

  bool operator==(const Rules&) const = default;
};

// Options of the command line: what is not given stays as it was in the earlier grading.
struct RulesAsked {
  std::optional<std::string> roster, due, overrides, attempt;
  std::optional<int> grace, penalty;
};
Rules rules_for(const RulesAsked& asked, const Rules& earlier);

// One line that says which rules hold; empty if there are none.
std::string sentence_of(const Rules& rules);

// Seconds since 1970 of "2027-01-15 22:00", "2027-01-15T22:00:30+01:00" or one with Z. A time without an offset
// is one of this machine's time zone. Nothing: it is another text.
std::optional<std::int64_t> seconds_of(const std::string& time);

// Moodle's names of files have no time: adds those of its worksheet, from the column "Last modified (submission)".
void add_times_of_moodle(const std::string& worksheet, std::vector<intake::HandedIn>& everybody);

// Adds everybody of the roster who has handed in nothing, and finds out who is late, by how many days. Returns
// sentences for the instructor. `quiet`: they name nobody. Throws pt::Error, with the line, if the roster or the time due cannot be used.
std::vector<std::string> apply_rules(const Rules& rules, std::vector<intake::HandedIn>& everybody,
                                     bool quiet);

// Points and a word by hand.
struct Override {
  std::optional<int> points;  // with bonus; nothing: those that were judged
  std::string word;           // may be empty
};

// By the place in `everybody`, whose names are the real ones. Throws pt::Error, with the line, if the table cannot be used, or names
// somebody who is not in the class.
std::map<std::size_t, Override> read_overrides(const std::string& path,
                                               const std::vector<intake::HandedIn>& everybody);

// The points that go back to the learner.
struct Grade {
  std::optional<int> points;  // with bonus; nothing: it could not be judged
  std::string reason;         // why these are not the points that were judged; else empty
};

// `judged`: points with bonus; nothing if it could not be judged. What is taken off is rounded down.
Grade grade_of(const intake::HandedIn& by, const std::optional<int>& judged, int penalty,
               const Override& by_hand);

}  // namespace grader::classes
