// example_page FOLDER: writes FOLDER/page.html, the page of a run with everything in it, for
// tests/page.sh.
#include "grader/report/write_reports.h"
#include "tests/example_results.h"

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const std::string folder = argv[1];
  grader::report::ReportFiles files;
  files.html = folder + "/page.html";
  grader::report::write_reports(example_results(folder), files);
  return 0;
}
