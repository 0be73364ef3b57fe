#include "grader/service/audit/audit.h"

#include "grader/base/printable.h"
#include "grader/service/audit/c_functions.h"
#include "grader/service/audit/object_file.h"
#include "pt/error.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <memory>

#include <cxxabi.h>
#include <elf.h>
#include <fmt/format.h>

namespace grader::audit {

namespace {

using std::string_view;

// The limit for a task's variables and code; beyond 2 GiB no linker can address them.
constexpr std::uint64_t kMaxMemory = std::uint64_t{256} << 20;
constexpr int kUnique = 10;  // STB_GNU_UNIQUE: inline variables and statics of templates
constexpr std::uint32_t kLinkerOptions = 0x6fff4c01;  // SHT_LLVM_LINKER_OPTIONS: from clang, empty
constexpr std::uint32_t kAddresses = 0x6fff4c03;      // SHT_LLVM_ADDRSIG: from clang
constexpr std::uint32_t kUnwind = 0x70000001;         // SHT_X86_64_UNWIND: from clang

// The types of sections that C++ compilers make. Other types mean something to a linker or a
// program loader.
constexpr std::uint32_t kSectionTypes[] = {
    SHT_NULL, SHT_PROGBITS, SHT_SYMTAB,     SHT_STRTAB,     SHT_RELA,   SHT_NOBITS, SHT_NOTE,
    SHT_REL,  SHT_GROUP,    SHT_INIT_ARRAY, SHT_FINI_ARRAY, kAddresses, kUnwind};
constexpr string_view kSectionNames[] = {
    ".text",        ".data",    ".rodata",  ".bss",        ".tdata",
    ".tbss",        ".debug_",  ".zdebug_", ".rela",       ".rel",
    ".group",       ".symtab",  ".strtab",  ".shstrtab",   ".gcc_except_table",
    ".eh_frame",    ".comment", ".note.",   ".init_array", ".fini_array",
    ".llvm_addrsig"};

// Parts of C++ names. A task needs no processes, threads or files, and must not call the judge's
// side of a worker.
constexpr string_view kForbidden[] = {"_ZN6grader", "_ZNK6grader", "_ZNSt6thread15_M_start",
                                      "_ZNSt10filesystem", "_ZNKSt10filesystem"};

bool begins(string_view name, string_view prefix) {
  return name.substr(0, prefix.size()) == prefix;
}

// The demangled name; empty if it is not a C++ name.
std::string demangled(const std::string& name) {
  int status = 0;
  const std::unique_ptr<char, decltype(&std::free)> text(
      abi::__cxa_demangle(name.c_str(), nullptr, nullptr, &status), &std::free);
  return text ? text.get() : "";
}

std::string readable(const std::string& name) {
  const std::string text = demangled(name);
  return base::printable(text.empty() ? name : text, 200);
}

// Returns whether a demangled name mentions a namespace ("pt::") anywhere.
bool mentions(string_view name, string_view space) {
  const auto is_part_of_a_name = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == ':';
  };
  for (std::size_t at = name.find(space); at != name.npos; at = name.find(space, at + 1)) {
    if (at == 0 || !is_part_of_a_name(name[at - 1])) return true;
  }
  return false;
}

// All forms of new and delete.
bool allocates(string_view name) {
  return begins(name, "_Znw") || begins(name, "_Zna") || begins(name, "_Zdl") ||
         begins(name, "_Zda");
}

bool forbidden(string_view name) {
  return std::any_of(std::begin(kForbidden), std::end(kForbidden),
                     [&](string_view prefix) { return begins(name, prefix); });
}

// Placement new and delete, which do nothing: they are inline functions of <new>.
bool places(string_view name) {
  return name == "_ZnwmPv" || name == "_ZnamPv" || name == "_ZdlPvS_" || name == "_ZdaPvS_";
}

// Names that a merged definition may have. "DW.ref.X" holds the address of X, the type of a caught
// exception.
bool may_be_merged(string_view name) {
  constexpr string_view kReference = "DW.ref.";
  if (begins(name, kReference)) {
    name.remove_prefix(kReference.size());
    if (name == "__gxx_personality_v0") return true;
  }
  return (begins(name, "_Z") && (!allocates(name) || places(name)) && !forbidden(name)) ||
         name == "__clang_call_terminate";
}

std::string judge_section(const ObjectSection& section) {
  if (section.type == kLinkerOptions && section.size == 0) return "";
  const bool known_name =
      section.name.empty() ||
      std::any_of(std::begin(kSectionNames), std::end(kSectionNames),
                  [&](string_view prefix) { return begins(section.name, prefix); });
  const bool known_type =
      std::count(std::begin(kSectionTypes), std::end(kSectionTypes), section.type) > 0;
  if (known_name && known_type) return "";
  return fmt::format("it has a section '{}', which no task needs",
                     base::printable(section.name, 100));
}

std::string judge_definition(const ObjectSymbol& symbol, const std::set<std::string>& contract) {
  const bool plain = symbol.section < SHN_LORESERVE;
  if (symbol.type == STT_FUNC && plain && contract.contains(symbol.name)) return "";
  const bool merged = symbol.binding == STB_WEAK || symbol.binding == kUnique;
  if (merged && symbol.in_group && symbol.type != STT_GNU_IFUNC && may_be_merged(symbol.name)) {
    return "";
  }
  return fmt::format(
      "it defines {}, which its contract does not: put helpers in the anonymous namespace",
      readable(symbol.name));
}

// Judges a symbol that is defined elsewhere.
std::string judge_request(const ObjectSymbol& symbol, const Task& task) {
  const std::string words = begins(symbol.name, "_Z") ? demangled(symbol.name) : "";
  if (mentions(words, "pt::")) {
    const std::string function = words.substr(0, words.find('('));
    if (may_call(task, function)) return "";
    return fmt::format("it calls {}; {}", base::printable(function, 200), may_call_in_words(task));
  }
  const bool needed = begins(symbol.name, "_Z") ? !forbidden(symbol.name) && !words.empty() &&
                                                      !mentions(words, "grader::")
                                                : is_harmless(symbol.name);
  return needed ? "" : fmt::format("it uses {}, which no task needs", readable(symbol.name));
}

}  // namespace

std::set<std::string> functions_in(string_view object) {
  std::set<std::string> names;
  for (const ObjectSymbol& symbol : read_object(object).symbols) {
    const bool defined = symbol.section != SHN_UNDEF;
    if (defined && symbol.binding == STB_GLOBAL && symbol.type == STT_FUNC)
      names.insert(symbol.name);
  }
  return names;
}

std::string audit(string_view bytes, const std::set<std::string>& contract, const Task& task) {
  try {
    const ObjectFile object = read_object(bytes);
    std::uint64_t bytes_of_all = 0;
    for (const ObjectSection& section : object.sections) {
      if (std::string reason = judge_section(section); !reason.empty()) return reason;
      // A section of the largest possible size must not make the sum overflow.
      bytes_of_all += std::min(section.size, kMaxMemory + 1);
    }
    if (bytes_of_all > kMaxMemory) {
      return fmt::format("its variables and its code take more than {} MiB", kMaxMemory >> 20);
    }
    for (const ObjectSymbol& symbol : object.symbols) {
      std::string reason = symbol.section == SHN_UNDEF ? judge_request(symbol, task)
                                                       : judge_definition(symbol, contract);
      if (!reason.empty()) return reason;
    }
    return "";
  } catch (const pt::Error& error) {
    return std::string("the compiled object is not accepted: ") + error.what();
  }
}

}  // namespace grader::audit
