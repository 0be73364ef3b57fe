#include "grader/service/audit/c_functions.h"

#include <algorithm>
#include <iterator>

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
    "rand", "srand", "strtod", "strtof", "strtold", "strtol", "strtoll", "strtoul", "strtoull",
    "strtoimax", "strtoumax", "wcstoimax", "wcstoumax", "calloc", "free", "malloc", "realloc",
    "aligned_alloc", "getenv", "mblen", "mbtowc", "wctomb", "mbstowcs", "wcstombs",
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
    "clock_gettime", "nanosleep", "sched_yield", "get_nprocs", "random", "lgamma_r", "lgammaf_r",
    "lgammal_r",
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

}  // namespace

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

}  // namespace grader::audit
