#include "grader/service/intake/boxed_readers.h"

#include "grader/base/descriptor.h"
#include "grader/base/printable.h"
#include "grader/service/intake/read_boxed.h"
#include "pt/error.h"
#include "pt/file.h"

#include <filesystem>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>

namespace grader::intake {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxReason = 300;

std::string unpack_one(const std::string& program, sandbox::Tier tier, const std::string& archive,
                       const std::string& folder, Extent extent,
                       const std::vector<NameForm>& table) {
  const std::string own_name = fs::path(archive).filename();
  const std::string name = base::printable(own_name, kMaxReason);
  const base::Descriptor file(open(archive.c_str(), O_RDONLY | O_CLOEXEC));
  if (!file.is_open()) return fmt::format("'{}' cannot be read", name);
  const bool is_of_all = extent == Extent::everybody;
  std::vector<std::string> command{program, own_name, is_of_all ? "everybody" : "one"};
  // As words: the box sees no file of the instructor.
  for (const NameForm& form : table) {
    if (is_of_all) command.insert(command.end(), {form.platform, form.pattern});
  }
  return read_boxed({.command = std::move(command),
                     .input = file.number(),
                     .folder = folder,
                     .seconds = is_of_all ? 3600U : 60U,
                     .name = name,
                     .done = "unpacked"},
                    tier);
}

std::string flatten_one(const std::string& program, const std::string& texts, sandbox::Tier tier,
                        const std::string& name, const door::Clone& clone,
                        const std::string& folder) {
  fs::create_directories(folder);
  const std::string packed = folder + ".packed";
  pt::write_file(packed, door::pack(clone));
  const base::Descriptor input(open(packed.c_str(), O_RDONLY | O_CLOEXEC));
  fs::remove(packed);
  if (!input.is_open()) throw pt::Error(packed + " cannot be read");
  return read_boxed({.command = {program, texts},
                     .visible = {texts},
                     .input = input.number(),
                     .folder = folder,
                     .name = base::printable(name, kMaxReason),
                     .done = "read"},
                    tier);
}

}  // namespace

Readers boxed_readers(const std::string& root, const std::string& work, const std::string& programs,
                      bool must_isolate, const std::vector<NameForm>& table) {
  const sandbox::Tier tier = tier_for_reading(root, work, must_isolate);
  const std::string unpack = programs + "/unpack", flatten = programs + "/flatten";
  const std::string texts = root + "/grader/door";
  return {
      [unpack, tier, table](const std::string& archive, const std::string& folder, Extent extent) {
        if (fs::exists(unpack)) return unpack_one(unpack, tier, archive, folder, extent, table);
        return fmt::format("'{}' cannot be unpacked here; unpack it first",
                           base::printable(fs::path(archive).filename().string(), kMaxReason));
      },
      [flatten, texts, tier](const std::string& name, const door::Clone& clone,
                             const std::string& folder) {
        return flatten_one(flatten, texts, tier, name, clone, folder);
      }};
}

}  // namespace grader::intake
