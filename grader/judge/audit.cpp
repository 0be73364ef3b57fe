#include "grader/judge/audit.h"

#include "grader/judge/c_functions.h"
#include "grader/judge/object_file.h"
#include "grader/process/printable.h"
#include "pt/error.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <memory>

#include <cxxabi.h>
#include <elf.h>
#include <fmt/format.h>

namespace grader {

namespace {

using std::string_view;

constexpr int kUnique = 10;  // STB_GNU_UNIQUE, of inline variables and statics of templates
constexpr std::uint32_t kLinkerOptions = 0x6fff4c01;  // SHT_LLVM_LINKER_OPTIONS, of clang: empty
constexpr std::uint32_t kAddresses = 0x6fff4c03;      // SHT_LLVM_ADDRSIG, of clang
constexpr std::uint32_t kUnwind = 0x70000001;         // SHT_X86_64_UNWIND, of clang

// What compilers make of C++. Others have a meaning for linkers, or for what starts a program.
constexpr std::uint32_t kSectionTypes[] = {
    SHT_NULL, SHT_PROGBITS, SHT_SYMTAB,     SHT_STRTAB,     SHT_RELA,   SHT_NOBITS, SHT_NOTE,
    SHT_REL,  SHT_GROUP,    SHT_INIT_ARRAY, SHT_FINI_ARRAY, kAddresses, kUnwind};
constexpr string_view kSectionNames[] = {
    ".text",        ".data",    ".rodata",  ".bss",        ".tdata",
    ".tbss",        ".debug_",  ".zdebug_", ".rela",       ".rel",
    ".group",       ".symtab",  ".strtab",  ".shstrtab",   ".gcc_except_table",
    ".eh_frame",    ".comment", ".note.",   ".init_array", ".fini_array",
    ".llvm_addrsig"};

// In the names of C++: processes, threads and files are nothing that a task needs, and the judge's
// side of a worker is not to be called.
constexpr string_view kForbidden[] = {"_ZN6grader", "_ZNK6grader", "_ZNSt6thread",
                                      "_ZNSt10filesystem", "_ZNKSt10filesystem"};

bool begins(string_view name, string_view prefix) {
  return name.substr(0, prefix.size()) == prefix;
}

std::string readable(const std::string& name) {
  int status = 0;
  const std::unique_ptr<char, decltype(&std::free)> text(
      abi::__cxa_demangle(name.c_str(), nullptr, nullptr, &status), &std::free);
  return printable(text ? text.get() : name, 200);
}

// new and delete, in all their forms.
bool allocates(string_view name) {
  return begins(name, "_Znw") || begins(name, "_Zna") || begins(name, "_Zdl") ||
         begins(name, "_Zda");
}

bool forbidden(string_view name) {
  return std::any_of(std::begin(kForbidden), std::end(kForbidden),
                     [&](string_view prefix) { return begins(name, prefix); });
}

// What a definition that the linker merges may be called.
bool may_be_merged(string_view name) {
  return (begins(name, "_Z") && !allocates(name) && !forbidden(name)) ||
         name == "DW.ref.__gxx_personality_v0" || name == "__clang_call_terminate";
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
  return fmt::format("it has a section '{}', which no task needs", printable(section.name, 100));
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

std::string judge_request(const ObjectSymbol& symbol) {
  if (begins(symbol.name, "_Z") ? !forbidden(symbol.name) : is_harmless(symbol.name)) return "";
  return fmt::format("it uses {}, which no task needs", readable(symbol.name));
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

std::string audit(string_view bytes, const std::set<std::string>& contract) {
  try {
    const ObjectFile object = read_object(bytes);
    for (const ObjectSection& section : object.sections) {
      if (std::string reason = judge_section(section); !reason.empty()) return reason;
    }
    for (const ObjectSymbol& symbol : object.symbols) {
      std::string reason =
          symbol.section == SHN_UNDEF ? judge_request(symbol) : judge_definition(symbol, contract);
      if (!reason.empty()) return reason;
    }
    return "";
  } catch (const pt::Error& error) {
    return std::string("what it compiles to is not accepted: ") + error.what();
  }
}

}  // namespace grader
