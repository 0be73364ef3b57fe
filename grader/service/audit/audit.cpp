#include "grader/service/audit/audit.h"

#include "grader/base/printable.h"
#include "grader/service/audit/object_file.h"
#include "pt/error.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <iterator>
#include <memory>
#include <string_view>

#include <cxxabi.h>
#include <elf.h>
#include <fmt/format.h>

namespace grader::audit {

namespace {

using std::string_view;

// Functions of one, two or three numbers; each also exists with the suffixes f and l.
constexpr string_view kMath[] = {
    "acos",         "acosh",     "asin",      "asinh",     "atan",       "atan2",  "atanh",
    "cbrt",         "ceil",      "copysign",  "cos",       "cosh",       "erf",    "erfc",
    "exp",          "exp10",     "exp2",      "expm1",     "fabs",       "fdim",   "floor",
    "fma",          "fmax",      "fmin",      "fmod",      "frexp",      "hypot",  "ilogb",
    "j0",           "j1",        "jn",        "ldexp",     "lgamma",     "llrint", "llround",
    "log",          "log10",     "log1p",     "log2",      "logb",       "lrint",  "lround",
    "modf",         "nan",       "nearbyint", "nextafter", "nexttoward", "pow",    "remainder",
    "remquo",       "rint",      "round",     "roundeven", "scalbln",    "scalbn", "sin",
    "sincos",       "sinh",      "sqrt",      "tan",       "tanh",       "tgamma", "trunc",
    "y0",           "y1",        "yn",        "cabs",      "carg",       "cexp",   "clog",
    "cpow",         "csqrt",     "ccos",      "csin",      "ctan",       "cacos",  "casin",
    "catan",        "ccosh",     "csinh",     "ctanh",     "cacosh",     "casinh", "catanh",
    "__fpclassify", "__signbit", "__isnan",   "__isinf",   "__finite"};

constexpr string_view kOthers[] = {
    // <cstring>, <cctype>
    "memchr", "memcmp", "memcpy", "memmove", "memset", "bcmp", "strcat", "strchr", "strcmp",
    "strcoll", "strcpy", "strcspn", "strerror", "strlen", "strncat", "strncmp", "strncpy",
    "strpbrk", "strrchr", "strspn", "strstr", "strtok", "strxfrm", "strnlen", "rawmemchr",
    "isalnum", "isalpha", "isblank", "iscntrl", "isdigit", "isgraph", "islower", "isprint",
    "ispunct", "isspace", "isupper", "isxdigit", "tolower", "toupper",
    // <cwchar>, <cwctype>, <cuchar>
    "wcscat", "wcschr", "wcscmp", "wcscoll", "wcscpy", "wcscspn", "wcsftime", "wcslen", "wcsncat",
    "wcsncmp", "wcsncpy", "wcspbrk", "wcsrchr", "wcsspn", "wcsstr", "wcstok", "wcsxfrm", "wmemchr",
    "wmemcmp", "wmemcpy", "wmemmove", "wmemset", "wcstod", "wcstof", "wcstold", "wcstol", "wcstoll",
    "wcstoul", "wcstoull", "btowc", "wctob", "mbsinit", "mbrlen", "mbrtowc", "wcrtomb", "mbsrtowcs",
    "wcsrtombs", "mbrtoc16", "mbrtoc32", "c16rtomb", "c32rtomb", "swprintf", "vswprintf", "swscanf",
    "vswscanf", "wprintf", "vwprintf", "fwprintf", "vfwprintf", "fputwc", "fputws", "putwc",
    "putwchar", "fwide", "iswalnum", "iswalpha", "iswblank", "iswcntrl", "iswctype", "iswdigit",
    "iswgraph", "iswlower", "iswprint", "iswpunct", "iswspace", "iswupper", "iswxdigit",
    "towctrans", "towlower", "towupper", "wctrans", "wctype",
    // <cstdlib>, <cinttypes>
    "abort", "abs", "labs", "llabs", "atexit", "at_quick_exit", "atof", "atoi", "atol", "atoll",
    "bsearch", "div", "ldiv", "lldiv", "imaxabs", "imaxdiv", "exit", "quick_exit", "_Exit", "qsort",
    "strtod", "strtof", "strtold", "strtol", "strtoll", "strtoul", "strtoull", "strtoimax",
    "strtoumax", "wcstoimax", "wcstoumax", "calloc", "free", "malloc", "realloc", "aligned_alloc",
    "getenv", "mblen", "mbtowc", "wctomb", "mbstowcs", "wcstombs",
    // <cstdio>
    "clearerr", "fclose", "feof", "ferror", "fflush", "fgetc", "fgetpos", "fgets", "fopen",
    "fprintf", "fputc", "fputs", "fread", "freopen", "fscanf", "fseek", "fsetpos", "ftell",
    "fwrite", "getc", "getchar", "perror", "printf", "putc", "putchar", "puts", "rewind", "scanf",
    "setbuf", "setvbuf", "snprintf", "sprintf", "sscanf", "stderr", "stdin", "stdout", "ungetc",
    "vfprintf", "vfscanf", "vprintf", "vscanf", "vsnprintf", "vsprintf", "vsscanf",
    // <ctime>, <clocale>, <cfenv>, <csetjmp>, <cassert>, <cerrno>
    "asctime", "clock", "ctime", "difftime", "gmtime", "localtime", "mktime", "strftime", "time",
    "timespec_get", "localeconv", "setlocale", "feclearexcept", "fegetenv", "fegetexceptflag",
    "fegetround", "feholdexcept", "feraiseexcept", "fesetenv", "fesetexceptflag", "fesetround",
    "fetestexcept", "feupdateenv", "longjmp", "_setjmp", "setjmp", "__sigsetjmp", "__assert_fail",
    "__assert_perror_fail", "__assert", "__errno_location", "__ctype_b_loc", "__ctype_tolower_loc",
    "__ctype_toupper_loc", "__ctype_get_mb_cur_max",
    // Functions behind classes of the C++ headers: shared_ptr (is there more than one thread?),
    // mutexes, call_once, condition variables, this_thread, chrono. None of them starts a thread.
    "__libc_single_threaded", "__once_proxy", "pthread_once", "pthread_self", "pthread_equal",
    "pthread_key_create", "pthread_key_delete", "pthread_getspecific", "pthread_setspecific",
    "clock_gettime", "nanosleep", "sched_yield", "get_nprocs", "lgamma_r", "lgammaf_r", "lgammal_r",
    // Functions that compilers insert calls to.
    "_GLOBAL_OFFSET_TABLE_", "__dso_handle", "__tls_get_addr", "__stack_chk_fail", "__dynamic_cast",
    "__cpu_model", "__cpu_indicator_init", "__emutls_get_address", "__fentry__"};

// Exceptions, atomic operations, conversions, sanitisers, and locks, which never wait with one
// thread.
constexpr string_view kPrefixes[] = {
    "__cxa_",        "_Unwind_",      "__gxx_",          "__gcc_",   "__atomic_",
    "__isoc99_",     "__isoc23_",     "__asan_",         "__ubsan_", "__sanitizer_",
    "pthread_mutex", "pthread_cond_", "pthread_rwlock_", "_ITM_",    "__gthrw_"};

template <std::size_t n>
bool among(const string_view (&names)[n], string_view name) {
  return std::find(std::begin(names), std::end(names), name) != std::end(names);
}

// Returns whether this is a libgcc function for arithmetic that the machine lacks: "__muldc3",
// "__udivti3", "__popcountdi2", "__floattidf". Its name is a word and the types of its numbers.
bool is_arithmetic(string_view name) {
  constexpr string_view kTypes[] = {"si", "di", "ti", "hf", "sf", "df",
                                    "xf", "tf", "sc", "dc", "xc", "tc"};
  if (name.substr(0, 2) != "__") return false;
  if (name.back() >= '2' && name.back() <= '4') name.remove_suffix(1);
  return name.size() > 6 && among(kTypes, name.substr(name.size() - 2)) &&
         std::all_of(name.begin() + 2, name.end(), [](char c) { return c >= 'a' && c <= 'z'; });
}

// Returns whether compiled C++ may need this C function: a function of ISO C that computes, prints
// or ends the program, or one that compilers insert calls to. Functions that use the operating
// system are not among them: fork, socket, dlopen, open, write, system, syscall, pthread_create,
// ...
bool is_harmless(string_view name) {
  if (among(kOthers, name) || among(kMath, name)) return true;
  const char last = name.empty() ? ' ' : name.back();
  if ((last == 'f' || last == 'l') && among(kMath, name.substr(0, name.size() - 1))) return true;
  for (const string_view prefix : kPrefixes) {
    if (name.substr(0, prefix.size()) == prefix) return true;
  }
  // "__memcpy_chk": the same with a check of the size.
  constexpr string_view kChecked = "_chk";
  if (name.size() > 6 && name.substr(0, 2) == "__" &&
      name.substr(name.size() - kChecked.size()) == kChecked) {
    return among(kOthers, name.substr(2, name.size() - 6));
  }
  return is_arithmetic(name);
}

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
  if (!begins(name, "_Z")) return "";  // "x" would be read as the code of a type, long long
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
  const std::string words = demangled(symbol.name);
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

std::string runs_early(string_view bytes) {
  try {
    for (const ObjectSection& section : read_object(bytes).sections) {
      if (begins(section.name, ".init_array.") || begins(section.name, ".rela.init_array."))
        return "it has a constructor with a priority, which no file needs";
    }
    return "";
  } catch (const pt::Error& error) {
    return std::string("the compiled object is not accepted: ") + error.what();
  }
}

}  // namespace grader::audit
