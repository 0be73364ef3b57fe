#!/usr/bin/env python3
"""std_includes.py [--fix] [ROOT]: names the files that use a name of the standard library whose header neither they nor the
headers of the project that they include ask for. Such a file compiles only while some other header of the library happens to
include it, which can change with the next release of the compiler. --fix writes the missing #include lines; clang-format
then sorts them. Exit code 1 if there is such a file."""
import functools
import os
import re
import subprocess
import sys

ALGORITHMS = """adjacent_find all_of any_of binary_search clamp copy copy_if copy_n count count_if equal equal_range fill fill_n find
find_if find_if_not for_each generate includes is_permutation is_sorted lexicographical_compare lower_bound max max_element merge min
min_element minmax minmax_element mismatch next_permutation none_of nth_element partial_sort partition remove_if replace reverse
rotate set_difference set_intersection set_union shuffle sort stable_partition stable_sort transform unique upper_bound""".split()
FUNCTIONS = """abs acos asin atan atan2 cbrt ceil copysign cos erf erfc exp expm1 fabs floor fma fmod frexp hypot isfinite isinf
isnan ldexp lgamma llround log log10 log1p log2 lrint lround nextafter pow rint round signbit sin sqrt tan trunc""".split()

USES = {  # header: what shows that it is used
    "algorithm": r"std::(%s)\s*[(<]" % "|".join(ALGORITHMS),
    "array": r"std::array<",
    "atomic": r"std::atomic",
    "bit": r"std::(bit_cast|bit_width|countl_zero|countr_zero|has_single_bit|popcount|rotl)\b",
    "charconv": r"std::(from_chars|to_chars)\b",
    "chrono": r"std::chrono\b",
    "cmath": r"std::(%s)\(" % "|".join(FUNCTIONS),
    "condition_variable": r"std::condition_variable",
    "cstdint": r"std::u?int(8|16|32|64|max|ptr)_t",
    "cstdio": r"std::(FILE|fclose|fflush|fgets|fopen|fprintf|fputs|fread|fwrite|perror|printf|puts|snprintf)\b",
    "cstdlib": r"std::(_Exit|abort|atoi|exit|getenv|quick_exit|strtod|strtol|strtoul|strtoull|system)\(",
    "cstring": r"std::(memcmp|memcpy|memmove|memset|strchr|strcmp|strerror|strlen|strsignal)\(",
    "deque": r"std::deque<",
    "filesystem": r"std::filesystem\b",
    "fstream": r"std::[io]?fstream",
    "functional": r"std::(function|greater|hash|less|plus)<|std::ref\(",
    "iterator": r"std::(back_inserter|istreambuf_iterator|ostream_iterator)",
    "limits": r"std::numeric_limits",
    "map": r"std::(multi)?map<",
    "memory": r"std::(make_shared|make_unique|shared_ptr|unique_ptr)\b",
    "mutex": r"std::(call_once|lock_guard|mutex|once_flag|scoped_lock|unique_lock)\b",
    "numbers": r"std::numbers\b",
    "numeric": r"std::(accumulate|gcd|inner_product|iota|midpoint|partial_sum|reduce|transform_reduce)\b",
    "optional": r"std::(optional<|nullopt)",
    "random": r"std::(mt19937|uniform_)",
    "regex": r"std::regex",
    "set": r"std::(multi)?set<",
    "span": r"std::span<",
    "sstream": r"std::[io]?stringstream",
    "stdexcept": r"std::(invalid_argument|logic_error|out_of_range|runtime_error)\b",
    "string": r"std::(string\b(?!_)|to_string)",
    "string_view": r"std::string_view",
    "thread": r"std::(jthread|this_thread|thread)\b",
    "tuple": r"std::(make_tuple|tie|tuple)\b",
    "unordered_map": r"std::unordered_map",
    "unordered_set": r"std::unordered_set",
    "variant": r"std::variant<|std::visit\(",
    "vector": r"std::vector<",
}
ALSO = {"string_view": {"string"}}  # headers that the standard lets do as well


@functools.lru_cache(None)
def included(path):
    """The headers of the library, and the files of the project, that a file includes itself."""
    with open(path, encoding="utf-8") as file:
        text = file.read()
    beside = os.path.dirname(path)
    ours = (name if os.path.exists(name) else os.path.join(beside, name) for name in re.findall(r'#include "([^"]+)"', text))
    return set(re.findall(r"#include <([a-z_]+)>", text)), [name for name in ours if os.path.exists(name)]


def reached(path):
    headers, seen, left = set(), set(), [path]
    while left:
        file = left.pop()
        if file not in seen:
            seen.add(file)
            headers |= included(file)[0]
            left += included(file)[1]
    return headers


def code_of(text):
    text = re.sub(r'R"([^(]*)\(.*?\)\1"', '""', text, flags=re.S)
    text = re.sub(r'"(\\.|[^"\\\n])*"', '""', text)
    return re.sub(r"//[^\n]*", "", text)


def missing_in(path):
    with open(path, encoding="utf-8") as file:
        code = code_of(file.read())
    have = reached(path)
    return [header for header, use in USES.items()
            if header not in have and not ALSO.get(header, set()) & have and re.search(use, code)]


def fix(path, headers):
    with open(path, encoding="utf-8") as file:
        lines = file.read().split("\n")
    new = ["#include <%s>" % header for header in headers]
    standard = [i for i, line in enumerate(lines) if re.match(r"#include <[a-z_]+>", line)]
    ours = [i for i, line in enumerate(lines) if line.startswith("#include ") or line == "#pragma once"]
    at = standard[0] if standard else ours[-1] + 1
    lines[at:at] = new if standard else [""] + new
    with open(path, "w", encoding="utf-8") as file:
        file.write("\n".join(lines))


def main():
    words = sys.argv[1:]
    fixes = "--fix" in words
    roots = [word for word in words if word != "--fix"]
    os.chdir(roots[0] if roots else os.path.join(os.path.dirname(os.path.abspath(__file__)), "../.."))
    listed = subprocess.run(["git", "ls-files", "*.h", "*.cpp"], check=True, capture_output=True, text=True).stdout.split("\n")
    files = [path for path in listed if path and os.path.exists(path)]
    if not files:
        sys.exit("git lists no file here")
    bad = 0
    for path in files:
        headers = missing_in(path)
        bad += bool(headers)
        if headers and fixes:
            fix(path, headers)
        elif headers:
            print("%s: include %s" % (path, ", ".join("<%s>" % header for header in headers)))
    print("%d files, %d without a header that they use" % (len(files), bad))
    return 1 if bad and not fixes else 0


if __name__ == "__main__":
    sys.exit(main())
