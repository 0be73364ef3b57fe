// Several codes beside each other: each is measured as `converge` measures one, and then compared method by method.
#include "measure/charts/gnuplot.h"
#include "measure/charts/numbers.h"
#include "measure/scene/begin.h"
#include "measure/scene/pixels.h"
#include "measure/scene/print.h"
#include "pt/end_of_program.h"
#include "pt/error.h"
#include "pt/file.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include <fmt/format.h>

namespace measure::scene {

namespace {

// One of the codes; without curves it has the reason.
struct Measured {
  const Subject* subject;
  std::vector<MethodCurve> curves;
  std::string problem;
  double cpu_seconds = 0;
  // By method: the time of a sample over that of the first code, measured in turns with it.
  std::map<std::string, Uncertain> sample_times;

  const std::string& name() const { return subject->name; }
};

const MethodCurve* find(const Measured& code, const Method& method) {
  const auto found = std::ranges::find(code.curves, method.id,
                                       [](const MethodCurve& curve) { return curve.method.id; });
  return found == code.curves.end() ? nullptr : &*found;
}

Uncertain product(const Uncertain& a, const Uncertain& b) {
  const double value = a.value * b.value;
  return {value, value * std::hypot(a.error / a.value, b.error / b.value)};
}

// Time for the same error over that of the same method of `first`; nothing where one of them has no time.
std::optional<Uncertain> times(const Measured& code, const Measured& first, const Method& method) {
  const MethodCurve *own = find(code, method), *other = find(first, method);
  if (own == nullptr || other == nullptr || own->fails || other->fails) return {};
  const Uncertain of_sample = code.sample_times.at(method.id);
  return product(ratio(own->error2_sample, other->error2_sample), of_sample);
}

std::string times_cell(const Measured& code, const Measured& first, const Method& method) {
  const MethodCurve* own = find(code, method);
  if (own == nullptr) return "not written";
  if (own->fails) return "fails";
  const std::optional<Uncertain> time = times(code, first, method);
  return time ? fmt::format("{:.3g} \u00b1 {:.2g}", time->value, time->error) : "-";
}

std::string error_cell(const Measured& code, const Method& method) {
  const MethodCurve* own = find(code, method);
  if (own == nullptr) return "not written";
  const Uncertain& error = own->points.back().error;
  return fmt::format("{} \u00b1 {:.2g}", percent(error.value), 100 * error.error);
}

template <class Cell>
std::string table(const std::vector<const Measured*>& codes, const Measured& first,
                  const Cell& cell) {
  constexpr std::size_t kLeast = 16;
  std::string text = fmt::format("  {:<35}", "");
  for (const Measured* code : codes) {
    text += fmt::format("  {:>{}}", code->name(), std::max(kLeast, code->name().size()));
  }
  for (const MethodCurve& curve : first.curves) {
    text += fmt::format("\n  {:<35}", curve.method.title);
    for (const Measured* code : codes) {
      text +=
          fmt::format("  {:>{}}", cell(*code, curve.method), std::max(kLeast, code->name().size()));
    }
  }
  return text + "\n";
}

const char* const kChart =
    R"gp(set title "{}, at most {} bounces\nsurvival .7 where nothing else is said; {}" noenhanced
set logscale y
set ylabel "efficiency: 1 / (time x error^2), beside {}"
set xtics rotate by -60 font "sans-serif,10" ({})
set xrange [-.5:{}]
set bmargin 11
set rmargin 8
set key top left
plot 1 lc rgb "#000000" lw 2 title "{}"{}
)gp";

// Efficiency of each code, method by method. A name can stand in a label of gnuplot, but for the signs that make letters small.
std::string for_label(std::string name) {
  std::ranges::replace(name, '_', ' ');
  return name;
}

void draw_several(const std::vector<const Measured*>& codes, const Measured& first,
                  const Options& options, const std::string& name) {
  std::string csv = "place,efficiency,error_of_it,method,code\n", tics, plots;
  for (std::size_t k = 0; k < first.curves.size(); ++k) {
    tics += fmt::format("{}\"{}\" {}", k > 0 ? ", " : "", first.curves[k].method.title, k);
  }
  int block = 0;
  for (std::size_t i = 0; i < codes.size(); ++i) {
    std::string rows;
    for (std::size_t k = 0; k < first.curves.size(); ++k) {
      const Method& method = first.curves[k].method;
      const std::optional<Uncertain> time = times(*codes[i], first, method);
      if (!time) continue;
      // Beside each other, so that all bars can be seen.
      const double place = static_cast<double>(k) + .12 * (static_cast<double>(i) + 1);
      rows +=
          fmt::format("{:.4g},{:.5g},{:.3g},\"{}\",\"{}\"\n", place, 1 / time->value,
                      time->error / (time->value * time->value), method.title, codes[i]->name());
    }
    if (rows.empty()) continue;  // gnuplot does not count empty blocks
    const OwnInk ink = own_ink(i);
    const std::string data =
        fmt::format("\"{}.csv\" index {} skip {}", name, block, block == 0 ? 1 : 0);
    csv += (block++ > 0 ? "\n\n" : "") + rows;
    plots += fmt::format(", {} using 1:2:3 with yerrorbars lc rgb \"{}\" lw 1.5 pt {} title \"{}\"",
                         data, ink.color, ink.mark, for_label(codes[i]->name()));
    plots += under_the_pointer({data, for_label(codes[i]->name()), "$1", "$2", "$2", "$3"});
  }
  pt::write_file(options.out / (name + ".csv"), csv);
  std::string who;
  for (const Measured* code : codes) who += (who.empty() ? "" : ", ") + code->name();
  const std::string machine = processor();
  draw(
      options.out, name,
      fmt::format(fmt::runtime(kChart), subject_of(options), options.bounces, machine, first.name(),
                  tics, static_cast<double>(first.curves.size()) - .3, first.name(), plots),
      caption_of(options,
                 fmt::format("Efficiency of {} beside {}, method by method", who, first.name()),
                 fmt::format("at most {} bounces, survival .7 where nothing else is said",
                             options.bounces),
                 machine));
}

Measured measured(const Call& call, const Subject& subject) {
  Call own = call;
  own.options.whose = subject.name;
  own.options.prefix = subject.name + ".";
  Measured code{&subject, {}, "", 0, {}};
  try {
    subject.open();
    Converged converged = run_converge(own);
    code.curves = std::move(converged.curves);
    code.cpu_seconds = converged.cpu_seconds;
    fmt::print("\n");
  } catch (const pt::Error& error) {
    code.problem = pt::sentence_of(error);
    fmt::print("{} cannot be measured: {}\n\n", subject.name, code.problem);
  }
  pt::flush_standard_output();
  return code;
}

// The time of a sample over that of the first code, for each method. Other work on the machine slows both alike, since they take
// turns.
class Turns {
 public:
  Turns(const Measured& first, const Options& options)
      : first_(first),
        options_(options),
        loaded_((first.subject->open(), load_scene(options))),
        pixels_(spread_pixels(options.width, options.height, kPixels, options.seed)) {}

  Uncertain beside_first(const Measured& code, const MethodCurve& curve) const {
    const Method& method = curve.method;
    const Checked& usual = curve.points[1];
    const double one = usual.seconds / usual.samples;
    const double fit =
        kOfOneRender * options_.seconds / (one * static_cast<double>(pixels_.size()));
    pt::RenderSettings settings{
        std::clamp(static_cast<int>(std::min(fit, 1e6)), 2, kMaxAdaptive), {}, 0, 1};
    if (method.adaptive) {
      settings.samples = kMaxAdaptive;
      settings.adaptive = pt::AdaptiveSettings{kMaxAdaptive, kBatch, kTolerances[1]};
    }
    std::vector<double> factors;
    for (int turn = 0; turn < kTurns; ++turn) {
      settings.seed = options_.seed + static_cast<std::uint64_t>(turn);
      const double theirs = time_of_sample(first_, method, settings);
      factors.push_back(time_of_sample(code, method, settings) / theirs);
    }
    return mean_of(factors);
  }

 private:
  static constexpr int kTurns = 5, kPixels = 300;
  static constexpr double kOfOneRender = .003;  // of the time for a code

  double time_of_sample(const Measured& code, const Method& method,
                        const pt::RenderSettings& settings) const {
    code.subject->open();
    const pt::View view{loaded_.scene,
                        frame_camera(loaded_, options_.framing, options_.width, options_.height),
                        path_of(method.way, method.light_samples), options_.width, options_.height};
    const RenderedPixels made = measure(view, settings, pixels_);
    return made.cpu_seconds / static_cast<double>(made.all_samples());
  }

  const Measured& first_;
  const Options& options_;
  pt::LoadedScene loaded_;
  std::vector<PixelAt> pixels_;
};

// An engine was measured in turns with the first method.
void compare_times(Measured& code, const Measured& first, const Turns& turns) {
  for (const MethodCurve& curve : first.curves) {
    const MethodCurve* own = find(code, curve.method);
    if (own == nullptr) continue;
    Uncertain& times = code.sample_times[curve.method.id];
    if (!curve.method.engine) {
      times = turns.beside_first(code, curve);
      continue;
    }
    const auto of_engine = [](const MethodCurve& engine, const Measured& whose) {
      return ratio(engine.error2_second, whose.curves[0].error2_second);
    };
    times = product(code.sample_times.at(first.curves[0].method.id),
                    ratio(of_engine(*own, code), of_engine(curve, first)));
  }
}

// For the write-up: the numbers of the first code that could be measured, as of `converge` alone, and those of each under its name.
void write_all(const std::vector<Measured>& all, const Measured& first, const Options& options) {
  const double pixels = static_cast<double>(options.width) * options.height;
  double cpu_seconds = 0;
  nlohmann::json codes = nlohmann::json::array();
  for (const Measured& code : all) {
    cpu_seconds += code.cpu_seconds;
    codes.push_back({{"name", code.name()}, {"problem", code.problem}, {"curves", nullptr}});
    if (!code.problem.empty()) continue;
    codes.back()["curves"] = to_json(code.curves, pixels, 0).at("curves");
    codes.back()["fastest"] = fastest(code.curves).method.id;
  }
  nlohmann::json out = to_json(first.curves, pixels, cpu_seconds);
  out["codes"] = std::move(codes);
  pt::write_file(options.out / "converge.json", out.dump());
}

}  // namespace

int run_several(const Call& call, const std::vector<Subject>& several) {
  const Options& options = call.options;
  std::vector<Measured> all;
  for (const Subject& subject : several) all.push_back(measured(call, subject));
  std::vector<Measured*> codes;
  for (Measured& code : all) {
    if (code.problem.empty()) codes.push_back(&code);
  }
  const int status = codes.size() == all.size() ? 0 : 1;
  if (codes.size() < 2) return status;
  const Measured& first = *codes[0];
  const std::vector<const Measured*> compared(codes.begin(), codes.end());
  const std::vector<const Measured*> others(codes.begin() + 1, codes.end());
  const Turns turns(first, options);
  for (Measured* code : codes) {
    if (code != &first) compare_times(*code, first, turns);
  }
  fmt::print("The error of the last picture of each method:\n{}",
             table(compared, first, error_cell));
  fmt::print("\nTime for the same error, beside {}; below 1 is less:\n{}", first.name(),
             table(others, first, [&](const Measured& code, const Method& method) {
               return times_cell(code, first, method);
             }));
  if (options.out.empty()) return status;
  std::string name;
  for (const Measured* code : codes) name += code->name() + ".";
  draw_several(others, first, options, name + "beside");
  write_all(all, first, options);
  return status;
}

}  // namespace measure::scene
