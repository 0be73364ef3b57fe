#pragma once

#include "grader/results/results.h"

#include <string>

// Text that would do harm if a page, a spreadsheet, XML or a terminal used it unchanged.
inline const std::string kHostile =
    "=<script>window.harmed = 1</script><img src=x onerror='window.harmed = 1'> \"q\" & ]]> "
    "</style></pre>{{verdict}} \x1b[2J\xff\xc0\x80 \xe2\x80\xae end";

// Every member has a value other than its default.
grader::results::Results full_results();

// A realistic run with a task in each possible state, and with pictures in all of theirs: right,
// wrong, too noisy, adaptive, with missing files, or never rendered. The files that it names are
// written to `folder`.
grader::results::Results example_results(const std::string& folder);
