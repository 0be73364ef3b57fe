#include "grader/door/edits.h"

#include "grader/door/code.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

namespace grader::door {

namespace {

// The functions for windows, threads and files in the pathtracer.cpp of 2019.
constexpr std::array kAroundTracing{"PathTracer",
                                    "~PathTracer",
                                    "set_scene",
                                    "set_camera",
                                    "set_frame_size",
                                    "has_valid_configuration",
                                    "update_screen",
                                    "stop",
                                    "clear",
                                    "start_visualizing",
                                    "start_raytracing",
                                    "render_to_file",
                                    "build_accel",
                                    "visualize_accel",
                                    "visualize_cell",
                                    "key_press",
                                    "raytrace_tile",
                                    "raytrace_cell",
                                    "worker_thread",
                                    "save_image",
                                    "save_sampling_rate_image",
                                    "log_ray_miss",
                                    "log_ray_hit"};

struct Edit {
  std::size_t begin = 0, end = 0;
  std::string text{};
};

std::size_t behind_blanks(std::string_view code, std::size_t at) {
  return std::min(code.find_first_not_of(" \t\r\n", at), code.size());
}

bool begins_line(std::string_view code, std::size_t at) {
  const std::size_t before = at == 0 ? code.npos : code.find_last_not_of(" \t", at - 1);
  return before == code.npos || code[before] == '\n';
}

void open_access(std::string_view code, std::vector<Edit>& edits) {
  for (const char* word : {"private", "protected"}) {
    const std::size_t size = std::string_view(word).size();
    for (std::size_t at = find_word(code, word); at != code.npos;
         at = find_word(code, word, at + 1)) {
      const std::size_t colon = behind_blanks(code, at + size);
      const bool is_label = colon < code.size() && code[colon] == ':' && begins_line(code, at);
      if (is_label) edits.push_back({at, at + size, "public"});
    }
  }
}

void make_virtual(std::string_view code, std::vector<Edit>& edits) {
  constexpr std::string_view kName = "PathTracer";
  for (std::size_t at = find_word(code, "class"); at != code.npos;
       at = find_word(code, "class", at + 1)) {
    const std::size_t name = behind_blanks(code, at + 5);
    const std::size_t open = behind_blanks(code, name + kName.size());
    if (code.substr(name, kName.size()) != kName || open >= code.size() || code[open] != '{')
      continue;
    edits.push_back({at, at, "FL_SEAMS "});
    edits.push_back({name + kName.size(), name + kName.size(), " : public Seams"});
    return;
  }
}

void shrink_counts(std::string_view code, std::vector<Edit>& edits) {
  const std::size_t name = find_word(code, "sampleCountBuffer");
  if (name == code.npos) return;
  for (const std::string_view type : {"std::vector<int>", "vector<int>"}) {
    const std::size_t begin = code.rfind(type, name);
    if (begin == code.npos || behind_blanks(code, begin + type.size()) != name) continue;
    return edits.push_back({begin, begin + type.size(), "FlOne<int>"});
  }
}

// The beginning of the line in which a definition begins, with its type.
std::size_t line_of(std::string_view code, std::size_t at) {
  const std::size_t before = code.rfind('\n', at);
  return before == code.npos ? 0 : before + 1;
}

void leave_out_windows(std::string_view code, std::vector<Edit>& edits) {
  for (const char* name : kAroundTracing) {
    for (const Definition& each : definitions_of(code, std::string("PathTracer::") + name)) {
      const std::size_t begin = line_of(code, each.name);
      const auto lines = std::count(code.begin() + static_cast<std::ptrdiff_t>(begin),
                                    code.begin() + static_cast<std::ptrdiff_t>(each.end), '\n');
      edits.push_back({begin, each.end, std::string(static_cast<std::size_t>(lines), '\n')});
    }
  }
}

}  // namespace

std::string edited(const std::string& text, const std::string& path, Generation generation) {
  const std::string code = only_code(text);
  std::vector<Edit> edits;
  if (generation == Generation::of_2019 && path == "src/pathtracer.cpp")
    leave_out_windows(code, edits);
  open_access(code, edits);
  make_virtual(code, edits);
  if (path.ends_with("pathtracer.h")) shrink_counts(code, edits);
  std::stable_sort(edits.begin(), edits.end(),
                   [](const Edit& a, const Edit& b) { return a.begin < b.begin; });
  std::string result;
  std::size_t done = 0;
  for (const Edit& each : edits) {
    if (each.begin < done) continue;
    result.append(text, done, each.begin - done).append(each.text);
    done = each.end;
  }
  return result.append(text, done);
}

}  // namespace grader::door
