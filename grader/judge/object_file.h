#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace grader::judge {

// The contents of a relocatable ELF object. Numbers are those of <elf.h>.
struct ObjectSection {
  std::string name;
  std::uint32_t type = 0;  // SHT_...
  std::uint64_t size = 0;  // in bytes
};

struct ObjectSymbol {
  std::string name;
  int binding = 0;        // STB_...
  int type = 0;           // STT_...
  unsigned section = 0;   // SHN_...; else the number of one of the sections
  bool in_group = false;  // that the linker takes once, however many objects have it (COMDAT)
};

struct ObjectFile {
  int machine = 0;  // EM_...
  std::vector<ObjectSection> sections;
  std::vector<ObjectSymbol> symbols;  // but the local ones
};

// Reads bytes that may be anything. Our own reader, as the texts of nm and readelf can be forged by
// names with blanks in them, and a program in a box costs more than all of this. Throws pt::Error
// with one sentence if the bytes are not a 64-bit relocatable object of this machine's byte order.
ObjectFile read_object(std::string_view bytes);

// Returns the object with its writable static variables in two sections of their own: those with an
// initial value, and those without. Variables of one thread stay where they are. The worker looks
// whether a task changes these sections (grader/wire/kept_state.h). Nothing else is different. Throws
// as read_object.
inline constexpr std::string_view kStateSections[] = {"firstlight_data", "firstlight_bss"};
std::string with_state_marked(std::string_view object);

// The name of the variable at a place in those sections of a program, one after the other, as the
// linker knows it; empty if there is none. Throws pt::Error if the bytes are not a 64-bit program.
std::string state_at(std::string_view program, std::uint64_t place);

}  // namespace grader::judge
