// The main program of ./run examples in the box. It is linked with a learner's examples and with solutions of the task. Its input
// has the numbers of the examples to run, and begins with ! if the first that does not hold is to be the last. It prints a line about
// each (grader/examples/run.h reads them). It has no secret: nothing that it prints says more than what the solution answered.
#include "pt/examples/example.h"
#include "pt/printable.h"
#include "pt/todo_list.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <sstream>
#include <type_traits>
#include <vector>

#include <unistd.h>

namespace {

struct Example {
  const char* name;
  pt::examples::Body body;
};

std::vector<Example>& all() {
  static std::vector<Example> examples;
  return examples;
}

int checks = 0;

// Ends an example.
struct DoesNotHold {
  std::string words;
};

std::string text_of(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.9g", value);
  return text;
}
std::string text_of(double a, double b, double c) {
  return "(" + text_of(a) + ", " + text_of(b) + ", " + text_of(c) + ")";
}
std::string text_of(pt::Vec3 v) { return text_of(v.x, v.y, v.z); }
std::string text_of(pt::Rgb c) { return text_of(c.r, c.g, c.b); }

double largest(double value) { return std::abs(value); }
double largest(pt::Vec3 v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }
double largest(pt::Rgb c) { return std::max({std::abs(c.r), std::abs(c.g), std::abs(c.b)}); }

// NaN is near nothing, and an infinite number only itself.
bool is_near(double a, double b, double most) { return a == b || std::abs(a - b) <= most; }
bool is_near(pt::Vec3 a, pt::Vec3 b, double most) {
  return is_near(a.x, b.x, most) && is_near(a.y, b.y, most) && is_near(a.z, b.z, most);
}
bool is_near(pt::Rgb a, pt::Rgb b, double most) {
  return is_near(a.r, b.r, most) && is_near(a.g, b.g, most) && is_near(a.b, b.b, most);
}

template <class Value>
void check_near(const char* text, Value value, Value expected, double most) {
  ++checks;
  if (is_near(value, expected, most)) return;
  throw DoesNotHold{std::string(text) + " is " + text_of(value) + ", where you expect " +
                    text_of(expected)};
}

// A precision that every contract asks for. Colours may be less precise: single precision is enough for them.
constexpr double kPrecision = 1e-6;
constexpr double kPrecisionOfColours = 1e-5;

template <class Value>
void check_near(const char* text, Value value, Value expected) {
  const double precision = std::is_same_v<Value, pt::Rgb> ? kPrecisionOfColours : kPrecision;
  check_near(text, value, expected, precision * std::max(1.0, largest(expected)));
}

std::string outcome_of(const Example& example) {
  checks = 0;
  try {
    example.body();
    return "holds " + std::to_string(checks);
  } catch (const DoesNotHold& failure) {
    return "fails " + failure.words;
  } catch (const std::exception& error) {
    return std::string("fails an exception ended it: ") + error.what();
  } catch (...) {
    return "fails an exception ended it";
  }
}

void print(int descriptor, std::string line) {
  std::replace(line.begin(), line.end(), '\n', ' ');
  line += '\n';
  if (write(descriptor, line.data(), line.size()) < 0) std::_Exit(1);
}

}  // namespace

namespace pt::examples {

bool add(const char* name, Body body) {
  all().push_back({name, body});
  return true;
}

void expect(const char* text, bool holds) {
  ++checks;
  if (!holds) throw DoesNotHold{std::string(text) + " does not hold"};
}

void near(const char* text, double value, double expected) { check_near(text, value, expected); }
void near(const char* text, Vec3 value, Vec3 expected) { check_near(text, value, expected); }
void near(const char* text, Rgb value, Rgb expected) { check_near(text, value, expected); }
void near(const char* text, double value, double expected, double most) {
  check_near(text, value, expected, most);
}
void near(const char* text, Vec3 value, Vec3 expected, double most) {
  check_near(text, value, expected, most);
}
void near(const char* text, Rgb value, Rgb expected, double most) {
  check_near(text, value, expected, most);
}

}  // namespace pt::examples

int main() {
  // Output of the examples is not kept.
  const int answers = dup(STDOUT_FILENO);
  close(STDOUT_FILENO);
  close(STDERR_FILENO);
  pt::silence_todo();
  std::string input;
  char byte = 0;
  while (read(STDIN_FILENO, &byte, 1) == 1) input += byte;
  std::istringstream numbers(input);
  for (const Example& example : all()) print(answers, std::string("example ") + example.name);
  const bool until_one_fails = input.starts_with('!');
  if (until_one_fails) numbers.get();
  for (std::size_t i = 0; numbers >> i;) {
    if (i >= all().size()) continue;
    print(answers, "runs " + std::to_string(i));
    const std::string outcome = outcome_of(all()[i]);
    print(answers, outcome);
    if (until_one_fails && !outcome.starts_with("holds")) break;
  }
  for (const std::string& slug : pt::todo_list()) print(answers, "todo " + slug);
  print(answers, "end");
  std::_Exit(0);
}
