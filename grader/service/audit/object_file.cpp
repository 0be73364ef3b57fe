#include "grader/service/audit/object_file.h"

#include "pt/error.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <initializer_list>

#include <elf.h>

namespace grader::audit {

namespace {

class Bytes {
 public:
  explicit Bytes(std::string_view bytes) : bytes_(bytes) {}

  Bytes part(std::uint64_t offset, std::uint64_t size) const {
    if (offset > bytes_.size() || size > bytes_.size() - offset) {
      throw pt::Error("the object file is incomplete");
    }
    return Bytes(bytes_.substr(offset, size));
  }

  template <class Struct>
  Struct at(std::uint64_t index) const {
    if (index > bytes_.size() / sizeof(Struct)) throw pt::Error("the object file is incomplete");
    Struct value;
    std::memcpy(&value, part(index * sizeof(Struct), sizeof(Struct)).bytes_.data(), sizeof value);
    return value;
  }
  template <class Struct>
  std::uint64_t count() const {
    return bytes_.size() / sizeof(Struct);
  }

  // The string ends at a zero, which must be there.
  std::string text(std::uint64_t offset) const {
    const std::size_t end = offset < bytes_.size() ? bytes_.find('\0', offset) : bytes_.npos;
    if (end == bytes_.npos) throw pt::Error("a name in it has no end");
    return std::string(bytes_.substr(offset, end - offset));
  }

 private:
  std::string_view bytes_;
};

bool is_one_of(int type, std::initializer_list<int> types) {
  return std::find(types.begin(), types.end(), type) != types.end();
}

Elf64_Ehdr header_of(const Bytes& file, std::initializer_list<int> types = {ET_REL}) {
  const auto header = file.at<Elf64_Ehdr>(0);
  constexpr int kOrder = std::endian::native == std::endian::little ? ELFDATA2LSB : ELFDATA2MSB;
  if (std::memcmp(header.e_ident, ELFMAG, SELFMAG) != 0 || header.e_ident[EI_CLASS] != ELFCLASS64 ||
      header.e_ident[EI_DATA] != kOrder || !is_one_of(header.e_type, types) ||
      header.e_shentsize != sizeof(Elf64_Shdr)) {
    throw pt::Error("it is not an object file of this machine");
  }
  return header;
}

std::vector<Elf64_Shdr> sections_of(const Bytes& file, const Elf64_Ehdr& header) {
  const Bytes table = file.part(header.e_shoff, std::uint64_t{header.e_shnum} * sizeof(Elf64_Shdr));
  std::vector<Elf64_Shdr> headers;
  for (std::uint64_t i = 0; i < header.e_shnum; ++i) headers.push_back(table.at<Elf64_Shdr>(i));
  return headers;
}

// The content of section `index`; empty if it has no content.
Bytes content(const Bytes& file, const std::vector<Elf64_Shdr>& headers, std::uint64_t index) {
  if (index >= headers.size()) throw pt::Error("it names a section that it does not have");
  const Elf64_Shdr& header = headers[index];
  if (header.sh_type == SHT_NOBITS) return Bytes({});
  return file.part(header.sh_offset, header.sh_size);
}

std::vector<ObjectSymbol> symbols_of(const Bytes& file, const std::vector<Elf64_Shdr>& headers) {
  std::vector<ObjectSymbol> symbols;
  for (std::uint64_t i = 0; i < headers.size(); ++i) {
    if (headers[i].sh_type != SHT_SYMTAB) continue;
    const Bytes table = content(file, headers, i);
    const Bytes names = content(file, headers, headers[i].sh_link);
    for (std::uint64_t each = 0; each < table.count<Elf64_Sym>(); ++each) {
      const auto symbol = table.at<Elf64_Sym>(each);
      if (ELF64_ST_BIND(symbol.st_info) == STB_LOCAL) continue;
      const bool grouped =
          symbol.st_shndx < headers.size() && (headers[symbol.st_shndx].sh_flags & SHF_GROUP) != 0;
      symbols.push_back({names.text(symbol.st_name), ELF64_ST_BIND(symbol.st_info),
                         ELF64_ST_TYPE(symbol.st_info), symbol.st_shndx, grouped});
    }
  }
  return symbols;
}

// Returns whether the section holds variables that stay writable once the program is loaded.
bool is_state(const Elf64_Shdr& section, const std::string& name) {
  const bool written = section.sh_size > 0 && (section.sh_flags & SHF_WRITE) != 0 &&
                       (section.sh_flags & SHF_ALLOC) != 0 && (section.sh_flags & SHF_TLS) == 0;
  const bool named =
      (name.starts_with(".data") && !name.starts_with(".data.rel.ro")) || name.starts_with(".bss");
  return written && named && (section.sh_type == SHT_PROGBITS || section.sh_type == SHT_NOBITS);
}

// The address of a place in the sections of state, counted through one section after the other. 0
// if it is beyond the last section.
std::uint64_t address_of_state(const std::vector<Elf64_Shdr>& headers, const Bytes& names,
                               std::uint64_t place) {
  for (const std::string_view name : kStateSections) {
    for (const Elf64_Shdr& section : headers) {
      if (names.text(section.sh_name) != name) continue;
      if (place < section.sh_size) return section.sh_addr + place;
      place -= section.sh_size;
    }
  }
  return 0;
}

template <class Struct>
void overwrite(std::string& bytes, std::uint64_t offset, const Struct& value) {
  std::memcpy(bytes.data() + offset, &value, sizeof value);
}

}  // namespace

ObjectFile read_object(std::string_view bytes) {
  const Bytes file(bytes);
  const Elf64_Ehdr header = header_of(file);
  const std::vector<Elf64_Shdr> headers = sections_of(file, header);

  ObjectFile object{header.e_machine, {}, {}};
  const Bytes names = content(file, headers, header.e_shstrndx);
  for (const Elf64_Shdr& each : headers) {
    object.sections.push_back({names.text(each.sh_name), each.sh_type, each.sh_size});
  }
  object.symbols = symbols_of(file, headers);
  return object;
}

// The section names and two new ones go to the end of the file.
std::string with_state_marked(std::string_view bytes) {
  const Bytes file(bytes);
  const Elf64_Ehdr header = header_of(file);
  std::vector<Elf64_Shdr> headers = sections_of(file, header);
  const Bytes names = content(file, headers, header.e_shstrndx);
  Elf64_Shdr& names_header = headers[header.e_shstrndx];
  if (names_header.sh_type == SHT_NOBITS) throw pt::Error("its sections have no names");
  std::string all(bytes.substr(names_header.sh_offset, names_header.sh_size));
  const auto with_value = static_cast<Elf64_Word>(all.size());
  all += std::string(kStateSections[0]) + '\0';
  const auto without = static_cast<Elf64_Word>(all.size());
  all += std::string(kStateSections[1]) + '\0';
  for (Elf64_Shdr& section : headers) {
    if (!is_state(section, names.text(section.sh_name))) continue;
    section.sh_name = section.sh_type == SHT_PROGBITS ? with_value : without;
  }
  names_header.sh_offset = bytes.size();
  names_header.sh_size = all.size();
  std::string marked = std::string(bytes) + all;
  for (std::uint64_t i = 0; i < headers.size(); ++i) {
    overwrite(marked, header.e_shoff + i * sizeof(Elf64_Shdr), headers[i]);
  }
  return marked;
}

std::string state_at(std::string_view program, std::uint64_t place) {
  const Bytes file(program);
  const Elf64_Ehdr header = header_of(file, {ET_EXEC, ET_DYN});
  const std::vector<Elf64_Shdr> headers = sections_of(file, header);
  const std::uint64_t address =
      address_of_state(headers, content(file, headers, header.e_shstrndx), place);
  for (std::uint64_t i = 0; i < headers.size() && address != 0; ++i) {
    if (headers[i].sh_type != SHT_SYMTAB) continue;
    const Bytes table = content(file, headers, i);
    const Bytes texts = content(file, headers, headers[i].sh_link);
    for (std::uint64_t each = 0; each < table.count<Elf64_Sym>(); ++each) {
      const auto symbol = table.at<Elf64_Sym>(each);
      const bool here = ELF64_ST_TYPE(symbol.st_info) == STT_OBJECT && symbol.st_value <= address &&
                        address - symbol.st_value < symbol.st_size;
      if (here) return texts.text(symbol.st_name);
    }
  }
  return "";
}

}  // namespace grader::audit
