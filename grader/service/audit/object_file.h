#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace grader::audit {

// The contents of a relocatable ELF object. <elf.h> defines the numbers.
struct ObjectSection {
  std::string name;
  std::uint32_t type = 0;  // SHT_...
  std::uint64_t size = 0;  // in bytes
};

struct ObjectSymbol {
  std::string name;
  int binding = 0;        // STB_...
  int type = 0;           // STT_...
  unsigned section = 0;   // SHN_..., or the index of a section
  bool in_group = false;  // COMDAT: the linker keeps one copy
};

struct ObjectFile {
  int machine = 0;  // EM_...
  std::vector<ObjectSection> sections;
  std::vector<ObjectSymbol> symbols;  // without local symbols
};

// Reads untrusted bytes. This is our own reader because names with blanks can forge the output of
// nm and readelf, and because a program in a box costs more than all of this. Throws pt::Error with
// one sentence if the bytes are not a 64-bit relocatable object of this machine's byte order.
ObjectFile read_object(std::string_view bytes);

// Returns the object with its writable static variables moved to two sections of their own: one for
// variables with an initial value, one for the rest. Thread-local variables stay where they are.
// The worker checks whether a task changes these sections (grader/service/wire/kept_state.h).
// Nothing else is different. Throws like read_object.
inline constexpr std::string_view kStateSections[] = {"firstlight_data", "firstlight_bss"};
std::string with_state_marked(std::string_view object);

// The linker's name of the variable at a place in a program's sections of state, counted through
// both; empty if there is none. Throws pt::Error if the bytes are not a 64-bit program.
std::string state_at(std::string_view program, std::uint64_t place);

}  // namespace grader::audit
