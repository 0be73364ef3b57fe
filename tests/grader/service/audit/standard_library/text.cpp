// Text, streams, locales and time.
#include <cassert>
#include <cctype>
#include <charconv>
#include <chrono>
#include <cinttypes>
#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <cuchar>
#include <cwchar>
#include <cwctype>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <locale>
#include <regex>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>

namespace pt {

namespace {

double strings() {
  using namespace std::string_literals;
  using namespace std::string_view_literals;
  std::string text = "abc"s + std::to_string(1.5) + std::string("def"sv);
  text.replace(0, 1, "xyz").insert(2, 3, '-');
  std::wstring wide = L"wide" + std::to_wstring(3);
  const std::u16string utf16 = u"\u00e9";
  const std::u32string utf32 = U"\u00e9";
  double number = 0;
  std::from_chars(text.data(), text.data() + text.size(), number);
  char digits[40];
  const auto end = std::to_chars(digits, digits + 40, 3.25);
  return std::stod("2.5") + std::stoi("7") + number + static_cast<double>(wide.find(L'd')) +
         static_cast<double>(end.ptr - digits) + std::strtod("1e3", nullptr) +
         static_cast<double>(utf16.size() + utf32.size() + std::strlen("abc")) +
         std::isalpha(text[0]) + std::toupper('a') + static_cast<double>(std::towupper(L'a')) +
         std::atof("2") + static_cast<double>(std::strtoimax("5", nullptr, 10)) +
         static_cast<double>(std::wcslen(L"abc"));
}

double streams() {
  const std::time_t zero = 0;
  std::ostringstream out;
  out << std::setw(8) << std::setprecision(3) << std::fixed << 2.5 << std::hex << 255
      << std::boolalpha << true << std::put_time(std::gmtime(&zero), "%Y");
  out.imbue(std::locale::classic());
  std::istringstream in("1 2.5 word");
  int a = 0;
  double b = 0;
  std::string c, line;
  in >> a >> b >> c;
  std::getline(in, line);
  std::stringstream both;
  both << a << ' ' << b;
  std::wostringstream wide;
  wide << L"wide " << 1.5;
  std::cerr << std::quoted("a \"text\"") << std::endl;
  std::clog << std::flush;
  std::cout.precision(3);
  std::ofstream nowhere("/nowhere/at/all");
  std::printf("%d %s\n", a, c.c_str());
  std::fprintf(stderr, "%5.2f\n", b);
  char text[20];
  std::snprintf(text, sizeof text, "%.3g", b);
  std::sscanf("4.5", "%lf", &b);
  assert(a == 1);
  return a + b + static_cast<double>(out.str().size()) + (nowhere ? 100 : 1);
}

double patterns() {
  const std::regex word("([a-z]+)=([0-9]+)", std::regex::icase);
  std::smatch match;
  const std::string text = "samples=16 depth=4";
  double sum = std::regex_search(text, match, word) ? std::stod(match[2]) : 0;
  for (std::sregex_iterator i(text.begin(), text.end(), word), end; i != end; ++i) sum += 1;
  try {
    const std::regex wrong("(");
  } catch (const std::regex_error&) {
    sum += 1;
  }
  const auto& facet = std::use_facet<std::numpunct<char>>(std::locale());
  return sum + static_cast<double>(std::regex_replace(text, word, "$1").size()) +
         (facet.decimal_point() == '.' ? 1 : 0) + (std::isspace(' ', std::locale()) ? 1 : 0);
}

double times() {
  using namespace std::chrono_literals;
  const auto start = std::chrono::steady_clock::now();
  const auto today = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
  const auto fine = std::chrono::high_resolution_clock::now();
  return took.count() >= 0 && std::difftime(today, 0) > 0 && std::clock() >= 0 &&
                 fine.time_since_epoch() > 0s && std::chrono::floor<std::chrono::hours>(90min) == 1h
             ? 1
             : -1;
}

double errors() {
  try {
    throw std::system_error(std::make_error_code(std::errc::invalid_argument), "here");
  } catch (const std::system_error& error) {
    return error.code() == std::errc::invalid_argument && std::strlen(error.what()) > 0 ? 1 : -1;
  }
}

}  // namespace

double task() { return strings() + streams() + patterns() + times() + errors(); }

}  // namespace pt
