#pragma once

#include "grader/judge/config.h"
#include "grader/report/results.h"

#include <string>

namespace grader {

// Hints come in three tiers: a question, a direction, the usual mistake (grader/tasks/<slug>/
// hints.md). Each time the next one is given, with what it says about the promises that failed when
// the task was last judged; after the task passes, they start again.
//
// `tier` is 1 to 3, or 0 for the next. Throws pt::Error if there is no such task, or no hints for
// it.
std::string hint(const Config& config, const std::string& slug, int tier);

// What hint() goes by: which promises fail.
void remember_failures(const Config& config, const Results& results);

// Tier 1 to 3 of the text of a hints.md: the general part, and below it the sections of the
// promises named (as properties). Empty if there is no such tier.
std::string hint_text(const std::string& hints, int tier, const std::vector<std::string>& promises);

}  // namespace grader
