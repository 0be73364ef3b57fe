#pragma once

#include "grader/results/results.h"

#include <string>

// Text that would do harm in a page, a spreadsheet, XML or a terminal that took it as it is.
inline const std::string kHostile =
    "=<script>window.harmed = 1</script><img src=x onerror='window.harmed = 1'> \"q\" & ]]> "
    "</style></pre>{{verdict}} \x1b[2J\xff\xc0\x80 \xe2\x80\xae end";

// Every member has a value that it does not have by default.
grader::results::Results full_results();

// A run as a person might see it, with a task in each state that a task can have, and pictures in
// all of theirs: right, wrong, too noisy, adaptive, of files that are missing, or never rendered.
// The files that it names are written to `folder`.
grader::results::Results example_results(const std::string& folder);
