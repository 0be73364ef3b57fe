// Makes the pages of ./run site (scripts/site.sh), which has made the samples and compiled the reference before.
#include "pt/command_line.h"
#include "site/pages.h"

#include <string>

#include <CLI/CLI.hpp>

int main(int argc, char** argv) {
  CLI::App app("Makes a static site of the handbook.");
  site::Sources sources;
  std::string folder;
  app.add_option("--root", sources.root, "of the project")->required();
  app.add_option("--samples", sources.samples, "pages of other commands");
  app.add_option("--live", sources.live, "the reference as a script");
  app.add_option("folder", folder, "where the site is written")->required();
  return pt::run_command_line(app, argc, argv, [&] {
    site::write_site(sources, folder);
    return 0;
  });
}
