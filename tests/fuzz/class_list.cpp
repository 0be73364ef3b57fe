// Exports of a class: Gradescope's list, and names of folders and files.
#include "grader/service/intake/handed_in.h"
#include "grader/service/intake/unpack.h"
#include "pt/error.h"
#include "pt/file.h"
#include "tests/fixtures/temporary_folder.h"
#include "tests/fuzz/input.h"

#include <algorithm>
#include <set>
#include <vector>

namespace {

namespace fs = std::filesystem;
using namespace grader::intake;

// Every line that can be a name becomes a file, and a folder with a file of the same name.
void make_class(const fs::path& folder, std::string_view text) {
  std::error_code ignored;
  int number = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    std::string name(text.substr(at, end - at));
    at = end + 1;
    if (name.empty() || name == "." || name == ".." || name.size() > 200) continue;
    for (char& c : name) c = c == '/' || c == '\0' ? '_' : c;
    fs::create_directories(folder / name, ignored);
    std::ofstream(folder / name / (name + ".cpp")) << "\n";
    std::ofstream(folder / (name + "_1_" + std::to_string(++number) + "_hit_box.cpp")) << "\n";
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  static const TemporaryFolder folder;
  const fs::path all = fs::path(folder.path()) / "class";
  fs::create_directories(all);
  std::string_view text = fuzz::as_text(bytes, size);
  if (!text.empty() && text[0] == '!') {
    make_class(all, text.substr(1));
  } else {
    fs::create_directories(all / "submission_1");
    fs::create_directories(all / "submission_2");
    pt::write_file(all / kGradescopeList, text);
  }
  try {
    std::set<std::string> names;
    const Readers nothing_read{[](const std::string&, const std::string&, Extent) {
      return std::string("it is not unpacked");
    }};
    const std::vector<TaskFile> tasks{{"2_bvh", "hit_box"}};
    static const std::vector<NameForm> forms =
        read_name_forms(FIRSTLIGHT_ROOT "/grader/name_forms.csv");
    for (const HandedIn& each :
         handed_in(all, folder.path() + "/work", tasks, nothing_read, forms).everybody) {
      fuzz::expect(names.insert(each.name).second);
      fuzz::expect(!each.name.empty() && each.name.find('/') == each.name.npos);
    }
  } catch (const pt::Error& error) {
    fuzz::expect_reason(error);
  }
  fs::remove_all(all);
  return 0;
}
