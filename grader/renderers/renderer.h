#pragma once

#include "grader/service/sandbox/box.h"
#include "pt/image/image.h"
#include "pt/scene/path_settings.h"

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

// A renderer that somebody else wrote: a command that renders one picture into a file.

namespace grader::renderers {

// The words that stand for what is asked, in any word of a command.
inline constexpr const char* kPlaceholders[]{
    "{scene}", "{width}", "{height}", "{samples}", "{depth}", "{seed}", "{from}", "{to}", "{out}"};

struct OtherRenderer {
  std::vector<std::string> command;  // its first word is a program, by a path or as PATH finds it
  std::vector<std::string>
      visible;  // files and folders that it may read besides its own (files_of)
  sandbox::Tier tier = sandbox::Tier::limits;
  std::chrono::seconds most{600};                 // processor time of one picture
  std::uint64_t memory = std::uint64_t{8} << 30;  // bytes
  std::string format = "exr";                     // of the file {out}: exr, pfm or hdr
  std::string folder;                             // empty, for its files
};

// Linear radiance, row 0 at the top. A path may meet `depth` surfaces after the first; bounces from .. to are added up.
struct Asked {
  std::string scene;  // a file
  int width = 0, height = 0;
  int samples = 0;  // per pixel
  int depth = 0, from = 0, to = 0;
  std::uint32_t seed = 0;  // below 2^31
};

// Throws pt::Error if the command has no {scene}, {out}, {seed} or {samples}, if it has one of {from} and {to} only, if
// a word in braces is none of kPlaceholders, or if its program cannot be found.
void require_command(const std::vector<std::string>& command);
bool takes_bounces(const std::vector<std::string>& command);

// The command's words with what is asked in the places; {out} is `out`.
std::vector<std::string> filled(const std::vector<std::string>& command, const Asked& asked,
                                const std::string& out);

// The path of the program, and what a command may read without being told: the folders of its program and of each file that it names.
std::string program_of(const std::vector<std::string>& command);
std::vector<std::string> files_of(const std::vector<std::string>& command);

// Renders in a box: no network, no files but those above, the limits of `renderer`. Throws NoPicture (judge_recipe.h), with a sentence for a
// person, if there is no picture that can be read.
pt::Image render(const OtherRenderer& renderer, const Asked& asked);

}  // namespace grader::renderers
