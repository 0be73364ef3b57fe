#pragma once

#include "grader/service/build/config.h"
#include "grader/service/classes/rules.h"
#include "grader/service/intake/handed_in.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

// The work for a class, in a file that several processes and machines can share.

namespace grader::classes {

// Submissions with equal task files, as indices in ClassPlan::everybody. Only the first is judged.
using Equal = std::vector<std::size_t>;

// The work of one process.
using Chunk = std::vector<Equal>;

struct ClassPlan {
  std::string id;                  // different for every plan
  std::string input;               // the exported folder or archive
  std::vector<std::string> words;  // options of `grade`, the same for everybody
  std::uint64_t seed = 1;          // of all random inputs
  std::string host;                // the machine on which it was made
  std::string former;              // reports of an earlier grading, to compare with; may be empty
  std::string assignment;          // the column in Canvas' table; empty: the export's name
  std::string worksheet;           // Moodle's table, to be filled in; may be empty
  Rules rules;                     // of the instructor
  bool likeness = true;            // whether to look for what is alike
  std::string salt;                // for numbers in an anonymous class; empty: names are shown
  std::vector<intake::HandedIn> everybody;
  std::vector<std::string> real_names;      // of everybody, if the class is anonymous; else empty
  std::vector<std::string> former_names{};  // of everybody, in `former`; empty for newcomers
  std::vector<Chunk> chunks;                // of all submissions that can be judged
  std::vector<std::string> unclaimed;       // files without an owner
  bool work_is_unclaimed = false;           // some of them may be somebody's work
  std::vector<std::string> remarks{};       // on the roster, to print; they are not written
};

struct PlanRequest {
  std::string input, out;
  std::vector<std::string> words;
  std::optional<std::uint64_t> seed;
  std::string former;      // reports of an earlier grading, to compare with; may be empty
  std::string assignment;  // the column in Canvas' table; empty: the export's name
  std::string worksheet;   // Moodle's table, to be filled in; may be empty
  RulesAsked rules;
  std::string forms;           // a table of forms of names; may be empty
  std::size_t chunk_size = 0;  // different submissions per chunk; 0: kMaxChunks chunks at most
  bool anonymous = false;
  bool no_likeness = false;  // do not look for what is alike
  bool must_isolate = true;  // an error if nothing isolates submissions and archives
};

// Slurm's usual limit (MaxArraySize) is 1001.
inline constexpr std::size_t kMaxChunks = 500;

// Lists the submissions, unpacks archives below `out` with the program `unpack` in the folder
// `programs`, and divides the class into chunks. The seed is the requested seed, else the seed of
// the reports in `out` or of the earlier grading, else random, so that nobody can prepare answers
// for it. It is kept in `out`. Throws pt::Error if there is no submission.
ClassPlan make_plan(const build::Config& config, const std::string& programs,
                    const PlanRequest& request, const intake::Progress& progress);

// Both use <out>/plan.json and, for an anonymous class, <out>/plan.names, which tells who is who.
// Reading throws pt::Error if the file is missing or not a plan.
void write_plan(const ClassPlan& plan, const std::string& out);
ClassPlan read_plan(const std::string& out);

// Everybody of the plan with their real names.
std::vector<intake::HandedIn> with_real_names(const ClassPlan& plan);

// The name of this machine.
std::string host_name();

}  // namespace grader::classes
