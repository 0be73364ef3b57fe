#pragma once

#include "grader/results/results.h"

#include <functional>
#include <string>

namespace grader::report {

// The results as one page that fetches nothing: pictures and their numbers are inside, read from
// the files that the results name (one that cannot be read becomes a sentence). Texts are escaped,
// and the page's policy lets it load nothing else. grader/report/page/ holds its template.
//
// A small page leaves out the values of pixels, and the maps of pictures that are right. If all
// pictures are right, it has a ninth of the bytes.
//
// The handbook and the contracts are named, and are links where there is an address for their files.
enum class PageSize { full, small };
// The address of a file of the project ("pt/tasks/hit_box.h") as the page has it; empty: it is not there.
using Link = std::function<std::string(const std::string& file)>;
std::string to_html(const results::Results& results, PageSize size = PageSize::full,
                    const Link& link = nullptr);

}  // namespace grader::report
