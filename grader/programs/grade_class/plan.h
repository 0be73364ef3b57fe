#pragma once

#include "grader/intake/handed_in.h"
#include "grader/judge/config.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

// All the work for a class, in a file, so that several processes and machines can share it.

namespace grader::programs {

// Submissions whose task files are equal, by their places in ClassPlan::everybody. The first is judged; all get its verdict.
using Equal = std::vector<std::size_t>;

// The work of one process.
using Chunk = std::vector<Equal>;

struct ClassPlan {
  std::string id;                  // unlike that of every other plan
  std::string input;               // the folder or archive, as it was exported
  std::vector<std::string> words;  // of the command line of `grade`, the same for all
  std::uint64_t seed = 1;          // of all random inputs
  std::string host;                // the machine on which it was made
  std::string former;              // reports of an earlier grading, to compare with; may be empty
  std::string assignment;          // its column in Canvas' table; empty: that of the export's name
  std::string worksheet;           // of Moodle, to be filled in; may be empty
  std::string salt;                // of the names of an anonymous class; empty: names are shown
  std::vector<intake::HandedIn> everybody;
  std::vector<std::string> real_names;  // of everybody, if the class is anonymous; else empty
  std::vector<std::string>
      former_names{};                  // of everybody, in `former`: empty for who was not in it
  std::vector<Chunk> chunks;           // of all that can be judged
  std::vector<std::string> unclaimed;  // files without an owner; not in the file
};

struct PlanRequest {
  std::string input, out;
  std::vector<std::string> words;
  std::optional<std::uint64_t> seed;
  std::string former;          // reports of an earlier grading, to compare with; may be empty
  std::string assignment;      // its column in Canvas' table; empty: that of the export's name
  std::string worksheet;       // of Moodle, to be filled in; may be empty
  std::size_t chunk_size = 0;  // submissions that differ, in a chunk; 0: kMaxChunks at most
  bool anonymous = false;
  bool must_isolate = true;  // refuses where nothing isolates submissions, archives among them
};

// Slurm's usual limit (MaxArraySize) is 1001.
inline constexpr std::size_t kMaxChunks = 500;

// Lists the submissions, unpacks archives below `out` with the program `unpack` in the folder `programs`, and cuts the
// class into chunks. The seed is the requested one, else that of the reports in `out` or of those to compare with, else a
// random one, so that nobody can prepare answers for a known seed. It is kept in `out`. Throws pt::Error if there is no
// submission.
ClassPlan make_plan(const judge::Config& config, const std::string& programs,
                    const PlanRequest& request, const intake::Progress& progress);

// <out>/plan.json. Reading throws pt::Error if the file is missing or is something else.
void write_plan(const ClassPlan& plan, const std::string& out);
ClassPlan read_plan(const std::string& out);

// The name of this machine.
std::string host_name();

}  // namespace grader::programs
