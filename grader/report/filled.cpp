#include "grader/report/filled.h"

#include "grader/report/page/sources.h"
#include "pt/error.h"

namespace grader::report {

std::string filled(std::string_view page, kainjow::mustache::data data) {
  kainjow::mustache::partial head{[] { return std::string(head_html); }};
  data.set("head", kainjow::mustache::data{head});
  kainjow::mustache::mustache filling{std::string(page)};
  std::string text = filling.render(data);
  if (!filling.is_valid()) throw pt::Error("the page cannot be made: " + filling.error_message());
  return text;
}

}  // namespace grader::report
