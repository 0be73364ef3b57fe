#include "pt/file.h"
#include "pt/math/vec3.h"
#include "writeup/exported.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

// Draws one path over the picture, from the numbers that ./run view exports.

namespace writeup {

namespace fs = std::filesystem;
using nlohmann::json;

double value_in(const json& value) { return value.is_number() ? value.get<double>() : NAN; }

std::string number_in(const json& value) {
  if (!value.is_number()) return value.is_string() ? value.get<std::string>() : kDash;
  const double number = value;
  return std::abs(number) < 1e-12 ? "0" : fmt::format("{:.3g}", number);
}

std::string svg(double height, const std::string& content) {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {:.0f}\" "
      "font-family=\"system-ui, sans-serif\" font-size=\"13\">\n{}</svg>\n",
      kDrawingWidth, height, content);
}

json exported(const Plan& plan, const Figure& figure, Drawn& drawn) {
  const Measurement measurement = plan.measurements(figure).at(0);
  if (!plan.measured().is_complete(measurement)) {
    drawn.problems.push_back(plan.measured().failure(measurement));
    return {};
  }
  drawn.numbers["x"] = std::to_string(figure.pixel[0]);
  drawn.numbers["y"] = std::to_string(figure.pixel[1]);
  json all = plan.measured().load(measurement);
  for (const json& task : all.at("paths").at("unwritten")) {
    drawn.problems.push_back("not written yet: " + task.get<std::string>());
  }
  return all;
}

namespace {

// Numbers that belong together stay in one line of a table.
std::string triple(const json& values) {
  return fmt::format("{}\u00a0{}\u00a0{}", number_in(values.at(0)), number_in(values.at(1)),
                     number_in(values.at(2)));
}

// One number for grey.
std::string color_in(const json& rgb) {
  const std::string red = number_in(rgb.at(0));
  return red == number_in(rgb.at(1)) && red == number_in(rgb.at(2)) ? red : triple(rgb);
}

double luminance_in(const json& color) {
  return luminance(pt::Rgb{value_in(color.at(0)), value_in(color.at(1)), value_in(color.at(2))});
}

pt::Vec3 vector_in(const json& v) {
  return {value_in(v.at(0)), value_in(v.at(1)), value_in(v.at(2))};
}

// The place of a point in the drawing; nothing if it is behind the camera.
std::optional<pt::Vec2> project(const json& camera, pt::Vec3 p, double height) {
  const pt::Vec3 d = p - vector_in(camera.at("position"));
  const double z = -dot(d, vector_in(camera.at("z")));
  if (!(z > 1e-9)) return std::nullopt;
  const auto half = [&](const char* angle) {
    return std::tan(camera.at(angle).get<double>() * pt::kPi / 360);
  };
  return pt::Vec2{
      (0.5 + dot(d, vector_in(camera.at("x"))) / (2 * z * half("hfov"))) * kDrawingWidth,
      (0.5 - dot(d, vector_in(camera.at("y"))) / (2 * z * half("vfov"))) * height};
}

// Lines between points of the scene, as they are seen in a picture.
class Overlay {
 public:
  Overlay(const json& camera, double height) : camera_(camera), height_(height) {}

  void line(pt::Vec3 a, pt::Vec3 b, const char* color, bool is_dashed) {
    const auto from = project(camera_, a, height_), to = project(camera_, b, height_);
    if (!from || !to) return;
    for (const auto& [stroke, width] : {std::pair{"#000", 4}, {color, 2}}) {
      text_ += fmt::format(
          "<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" stroke=\"{}\" stroke-width=\"{}\"{}/>\n",
          from->x, from->y, to->x, to->y, stroke, width,
          is_dashed ? " stroke-dasharray=\"6 5\"" : "");
    }
  }

  void point(pt::Vec3 p, int number) {
    const auto at = project(camera_, p, height_);
    if (!at) return;
    text_ += fmt::format(
        "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4\" fill=\"#ffd84a\" stroke=\"#000\"/>\n"
        "<text x=\"{:.1f}\" y=\"{:.1f}\" font-weight=\"bold\" fill=\"#ffd84a\" stroke=\"#000\" "
        "stroke-width=\"3\" "
        "paint-order=\"stroke\">{}</text>\n",
        at->x, at->y, at->x + 6, at->y - 6, number);
  }

  const std::string& text() const { return text_; }

 private:
  const json& camera_;
  double height_;
  std::string text_;
};

std::string drawing_of_path(const json& all, const json& path, double height) {
  Overlay overlay(all.at("scene").at("camera"), height);
  const json& bounces = path.at("bounces");
  for (std::size_t i = 0; i < bounces.size(); ++i) {
    const pt::Vec3 p = vector_in(bounces[i].at("p"));
    const json& direct = bounces[i].at("direct");
    for (const json& draw : direct.is_null() ? json::array() : direct.at("draws")) {
      if (!draw.at("traced") || !draw.at("distance").is_number()) continue;
      const bool is_hidden = draw.at("hidden");
      overlay.line(p, p + draw.at("distance").get<double>() * vector_in(draw.at("wi")),
                   is_hidden ? "#ff5a4d" : "#52d273", is_hidden);
    }
    if (i > 0) overlay.line(vector_in(bounces[i - 1].at("p")), p, "#ffd84a", false);
  }
  for (std::size_t i = 0; i < bounces.size(); ++i) {
    overlay.point(vector_in(bounces[i].at("p")), static_cast<int>(i) + 1);
  }
  return fmt::format("<image href=\"{}\" width=\"{}\" height=\"{:.0f}\"/>\n{}",
                     all.at("picture").get<std::string>(), kDrawingWidth, height, overlay.text());
}

// Says how a path went on from a point, or why it ended there.
std::string end_of(const json& bounce, bool is_last, int most, int point) {
  std::string drawn;
  for (const json& xi : bounce.at("drawn")) drawn += (drawn.empty() ? "" : ", ") + number_in(xi);
  if (!bounce.contains("wi")) {
    if (point >= most) return "bounce limit";
    return drawn.empty() ? "ends" : drawn + ": ends";
  }
  std::string text = drawn.empty() ? "goes\u00a0on" : drawn;
  if (bounce.at("survival") != 1) text += ": \u00f7\u00a0" + number_in(bounce.at("survival"));
  return is_last ? text + ", leaves the scene" : text;
}

void add_rows(const json& path, int most, Drawn& drawn) {
  drawn.columns = {"point", "place",       "direct light", "throughput",
                   "part",  "f cos / pdf", "roulette"};
  const json& bounces = path.at("bounces");
  for (std::size_t i = 0; i < bounces.size(); ++i) {
    const json& bounce = bounces[i];
    const int point = static_cast<int>(i) + 1;
    const bool goes_on = bounce.contains("wi");
    drawn.rows.push_back(
        {std::to_string(point), triple(bounce.at("p")),
         bounce.at("direct").is_null() ? kDash : color_in(bounce.at("direct").at("light")),
         color_in(bounce.at("throughput")), color_in(bounce.at("part")),
         goes_on ? fmt::format("{} \u00b7 {} / {}", color_in(bounce.at("f")),
                               number_in(bounce.at("cos")), number_in(bounce.at("pdf")))
                 : kDash,
         end_of(bounce, point == static_cast<int>(bounces.size()), most, point)});
  }
  for (const auto& [name, field] : {std::pair{"sum", "sum"}, {"trace_path", "traced"}}) {
    drawn.rows.push_back({name, "", "", "", color_in(path.at(field)), "", ""});
  }
}

void enter_path(const json& path, Drawn& drawn) {
  const json& bounces = path.at("bounces");
  double indirect = 0;
  int lights = 0, hidden = 0;
  for (std::size_t i = 0; i < bounces.size(); ++i) {
    if (i > 0) indirect += luminance_in(bounces[i].at("part"));
    const json& direct = bounces[i].at("direct");
    for (const json& draw : direct.is_null() ? json::array() : direct.at("draws")) {
      if (!draw.at("traced")) continue;
      ++lights;
      hidden += draw.at("hidden").get<bool>() ? 1 : 0;
    }
  }
  const auto enter = [&](const char* name, double value) { drawn.numbers[name] = digits(value); };
  enter("points", static_cast<double>(bounces.size()));
  enter("direct", luminance_in(bounces[0].at("part")));
  enter("indirect", indirect);
  enter("result", luminance_in(path.at("traced")));
  enter("throughput", luminance_in(bounces.back().at("throughput")));
  enter("is_exact", path.at("same").get<bool>() ? 1 : 0);
  enter("lights", lights);
  enter("hidden", hidden);
}

}  // namespace

Drawn draw_path(const Plan& plan, const Figure& figure, const fs::path& folder) {
  Drawn drawn;
  const json all = exported(plan, figure, drawn);
  if (!drawn.problems.empty()) return drawn;
  const json& paths = all.at("paths").at("paths");
  const auto longest = std::ranges::max_element(
      paths, {}, [](const json& path) { return path.at("bounces").size(); });
  if (longest == paths.end() || longest->at("bounces").empty()) {
    drawn.problems.emplace_back("no ray of this pixel meets a surface");
    return drawn;
  }
  drawn.numbers["paths"] = std::to_string(paths.size());
  enter_path(*longest, drawn);
  add_rows(*longest, std::stoi(all.at("settings").at("bounces").get<std::string>()), drawn);
  const double height = kDrawingWidth * figure.size[1] / figure.size[0];
  drawn.charts = {figure.id + ".svg"};
  pt::write_file(folder / drawn.charts[0], svg(height, drawing_of_path(all, *longest, height)));
  drawn.tables = {figure.id + ".csv"};
  std::string csv = fmt::format("\"{}\"\n", fmt::join(drawn.columns, "\",\""));
  for (const std::vector<std::string>& row : drawn.rows) {
    csv += fmt::format("\"{}\"\n", fmt::join(row, "\",\""));
  }
  pt::write_file(folder / drawn.tables[0], csv);
  return drawn;
}

}  // namespace writeup
