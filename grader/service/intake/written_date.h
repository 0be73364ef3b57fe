#pragma once

#include <string>

namespace grader::intake {

// A date and a time as platforms write them: "Jan 15, 2027 1005 PM", "15 January, 2027 2205", "2027-01-15 22 05",
// "2027-01-15-22-05-33", "Friday, 15 January 2027, 10:05 PM".
struct WrittenDate {
  bool is_date = false;
  std::string
      order;  // compares like the time; empty if the month is in a language that is not known
  std::string time;  // "2027-01-15 22:05"; empty with `order`
};

// Months are read in English, French, German and Spanish.
WrittenDate written_date(const std::string& text);

}  // namespace grader::intake
