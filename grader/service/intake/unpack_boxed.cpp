#include "grader/service/intake/unpack_boxed.h"

#include "grader/base/descriptor.h"
#include "grader/base/printable.h"
#include "grader/service/intake/read_boxed.h"

#include <filesystem>

#include <fcntl.h>
#include <fmt/format.h>

namespace grader::intake {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxReason = 300;

std::string unpack_one(const std::string& program, sandbox::Tier tier, const std::string& archive,
                       const std::string& folder, Extent extent) {
  const std::string own_name = fs::path(archive).filename();
  const std::string name = base::printable(own_name, kMaxReason);
  const base::Descriptor file(open(archive.c_str(), O_RDONLY | O_CLOEXEC));
  if (!file.is_open()) return fmt::format("'{}' cannot be read", name);
  const bool is_of_all = extent == Extent::everybody;
  return read_boxed({.command = {program, own_name, is_of_all ? "everybody" : "one"},
                     .input = file.number(),
                     .folder = folder,
                     .seconds = is_of_all ? 3600U : 60U,
                     .name = name,
                     .done = "unpacked"},
                    tier);
}

}  // namespace

Unpack unpack_boxed(const std::string& root, const std::string& work, const std::string& programs,
                    bool must_isolate) {
  const std::string program = programs + "/unpack";
  if (!fs::exists(program)) {
    return [](const std::string& archive, const std::string&, Extent) {
      return fmt::format("'{}' cannot be unpacked here; unpack it first",
                         base::printable(fs::path(archive).filename().string(), kMaxReason));
    };
  }
  const sandbox::Tier tier = tier_for_reading(root, work, must_isolate);
  return [program, tier](const std::string& archive, const std::string& folder, Extent extent) {
    return unpack_one(program, tier, archive, folder, extent);
  };
}

}  // namespace grader::intake
