#pragma once

#include "grader/results/results.h"

#include <string>

namespace grader::report {

// The results as one page that fetches nothing: pictures and their numbers are inside, read from
// the files that the results name (one that cannot be read becomes a sentence). Texts are escaped,
// and the page's policy lets it load nothing else. grader/report/page/ holds its template.
//
// A small page has no numbers of pixels, and no maps of pictures that are right: a ninth of the bytes
// where all pictures are.
enum class PageSize { full, small };
std::string to_html(const results::Results& results, PageSize size = PageSize::full);

}  // namespace grader::report
