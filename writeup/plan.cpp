#include "writeup/plan.h"

#include "grader/tasks.h"
#include "pt/error.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace writeup {

namespace {

constexpr int kDraftSize = 4;         // times fewer pixels on each side
constexpr int kDraftSamples = 16;     // times fewer, where a pixel is adaptive
constexpr int kDraftAsMany = 64;      // up to so many samples, a draft has as many
constexpr int kDraftFewer = 8;        // times fewer, above that
constexpr int kDraftGolden = 256;     // a golden has so many: four times any picture's
constexpr double kDraftSeconds = 40;  // times less time for a measurement
constexpr double kDraftCurves = 8;    // times less time for curves
constexpr int kUniformBatches = 2;
constexpr int kSmall = 100;  // pixels wide: small enough for a draft
// Tests of one triangle by one ray that a cell without a tree may take in a turn.
constexpr double kLinearTests = 1e8;
constexpr double kDraftLinearTests = 3e6;

measure::Spec draft(measure::Spec spec) {
  if (spec.width <= kSmall) return spec;
  spec.width /= kDraftSize;
  spec.height = std::max(spec.height / kDraftSize, 1);
  if (!spec.adaptive) {
    spec.samples = std::min(spec.samples, std::max(kDraftAsMany, spec.samples / kDraftFewer));
  } else {
    spec.samples = std::max(spec.samples / kDraftSamples, 32);
    spec.adaptive->batch = 8;
    spec.adaptive->tolerance *= std::sqrt(kDraftSamples);  // as accurate as so few samples can be
    spec.adaptive->max_samples = spec.samples;
  }
  return spec;
}

std::string without_bounces(const measure::Spec& spec, const std::string& scene) {
  nlohmann::json all = to_json(spec);
  all.erase("bounces");
  all.erase("engine");
  all["scene"] = scene;
  return all.dump();
}

}  // namespace

Plan::Plan(const Catalogue& catalogue, const Codes& codes, const Scenes& scenes, const Store& store,
           const Measurements& measured, Quality quality)
    : codes_(codes), scenes_(scenes), store_(store), measured_(measured), quality_(quality) {
  const auto add = [&](const Picture& picture) {
    if (!picture.in_bounces) return;
    const measure::Spec spec = quality == Quality::draft ? draft(picture.spec) : picture.spec;
    std::vector<pt::BounceRange>& ranges = ranges_[without_bounces(spec, picture.scene)];
    const pt::BounceRange range{spec.path.from, spec.path.to};
    if (std::find(ranges.begin(), ranges.end(), range) == ranges.end()) ranges.push_back(range);
  };
  for (const Figure& figure : catalogue.figures) {
    for (const Picture& picture : figure.pictures) add(picture);
  }
}

const Code& Plan::code_of(const Picture& picture) const {
  if (picture.mistake.empty()) return codes_.chosen;
  return codes_.mistakes.at(picture.mistake);
}

std::string Plan::unavailable(const Picture& picture) const {
  if (picture.mistake.empty() || codes_.mistakes.contains(picture.mistake)) return "";
  return "This edition comes without the " +
         (picture.mistake == kReference ? "reference." : "wrong solution " + picture.mistake + ".");
}

// A mistake may be in one of the tasks that trace.
bool Plan::traces_as_reference(const Picture& picture) const {
  if (picture.mistake.empty()) return codes_.reference_rays;
  const auto reference = codes_.mistakes.find(kReference);
  if (!codes_.reference_rays && reference == codes_.mistakes.end()) return false;
  const Code& right = codes_.reference_rays ? codes_.chosen : reference->second;
  const auto& hash = code_of(picture).hash;
  return std::ranges::all_of(grader::tracing_tasks(), [&](const std::string& task) {
    return hash.at(task) == right.hash.at(task);
  });
}

Unit Plan::unit(const Picture& picture) const {
  measure::Spec spec = quality_ == Quality::draft ? draft(picture.spec) : picture.spec;
  if (picture.golden)
    spec.samples = std::max(spec.samples, std::min(picture.spec.samples, kDraftGolden));
  spec.scene = scenes_.path(picture.scene);
  // The fast engine gives the same pictures, bit for bit, as the reference's own tree.
  if (traces_as_reference(picture) && spec.engine == pt::Engine::task && !spec.path.show_normals) {
    spec.engine = pt::Engine::wide;
  }
  return {spec, &code_of(picture)};
}

// One render for all wanted ranges of these bounces. If the form of the code's trace_path does not
// allow that, renders whose sum is the same.
std::vector<Unit> Plan::in_bounces(const Unit& whole, const std::string& scene) const {
  const std::vector<pt::BounceRange>& ranges = ranges_.at(without_bounces(whole.spec, scene));
  const pt::BounceRange wanted{whole.spec.path.from, whole.spec.path.to};
  Unit walk = whole;
  walk.spec.ranges = ranges;
  walk.spec.path.from = 0;
  walk.spec.path.to = 0;
  for (const pt::BounceRange& range : ranges) {
    walk.spec.path.to = std::max(walk.spec.path.to, range.to);
    if (range == wanted) walk.range = static_cast<int>(&range - ranges.data());
  }
  if (!store_.failure(walk).starts_with(measure::kRangesNotApart)) return {walk};
  std::set<int> cuts;
  for (const pt::BounceRange& range : ranges) cuts.insert({range.from, range.to + 1});
  std::vector<Unit> layers;
  for (auto cut = cuts.lower_bound(wanted.from); *cut <= wanted.to;) {
    Unit layer = whole;
    layer.spec.path.from = *cut;
    layer.spec.path.to = *++cut - 1;
    layers.push_back(layer);
  }
  return layers;
}

Unit Plan::for_time_of(const Picture& target, Unit pilot) const {
  const Unit other = unit(target);
  const bool known = store_.is_complete(pilot) && store_.is_complete(other);
  if (!known) return pilot;
  const double factor = store_.load(other).seconds / std::max(store_.load(pilot).seconds, 1e-3);
  pilot.spec.samples = std::max(1, static_cast<int>(std::lround(pilot.spec.samples * factor)));
  return pilot;
}

std::vector<Unit> Plan::units(const Figure& figure, const Picture& picture) const {
  const Unit whole = unit(picture);
  if (picture.in_bounces) return in_bounces(whole, picture.scene);
  if (picture.time_of.empty()) return {whole};
  for (const Picture& target : figure.pictures) {
    if (target.id == picture.time_of) return {for_time_of(target, whole)};
  }
  throw pt::Error("figure " + figure.id + " has no picture '" + picture.time_of + "'");
}

Unit Plan::uniform(const Picture& picture) const {
  Unit uniform = unit(picture);
  uniform.spec.samples = kUniformBatches * uniform.spec.adaptive->batch;
  uniform.spec.adaptive.reset();
  return uniform;
}

Unit Plan::cell(const std::string& scene, pt::Engine engine, int turn) const {
  measure::Spec spec;
  spec.seed = turn + 1;
  spec.path.show_normals = true;
  spec.path.to = 5;
  spec.engine = engine;
  spec.scene = scenes_.path(scene);
  const bool is_draft = quality_ == Quality::draft;
  if (is_draft) spec = draft(spec);
  if (engine == pt::Engine::linear) {
    const double tests = is_draft ? kDraftLinearTests : kLinearTests;
    const double rays = tests / scenes_.triangles(scene);
    const double shrink = std::min(1.0, std::sqrt(rays / spec.pixels()));
    spec.width = std::max(16, static_cast<int>(spec.width * shrink));
    spec.height = std::max(12, static_cast<int>(spec.height * shrink));
  }
  return {spec, &codes_.chosen};
}

namespace {

std::set<std::string> scenes_of(const Figure& figure) {
  std::set<std::string> names(figure.scenes.begin(), figure.scenes.end());
  for (const Picture& picture : figure.pictures) names.insert(picture.scene);
  return names;
}

}  // namespace

bool Plan::is_prepared(const Figure& figure) const {
  const std::set<std::string> names = scenes_of(figure);
  return std::all_of(names.begin(), names.end(), [&](const std::string& name) {
    return std::filesystem::exists(scenes_.path(name));
  });
}

void Plan::prepare(const Figure& figure) const {
  for (const std::string& name : scenes_of(figure)) scenes_.prepare(name);
}

std::vector<Unit> Plan::units(const Figure& figure) const {
  std::vector<Unit> all;
  for (const std::string& scene : figure.scenes) {
    if (figure.kind != "speedup") break;
    for (int turn = 0; turn < kTurns; ++turn) {
      for (const pt::Engine engine : kEngines) all.push_back(cell(scene, engine, turn));
    }
  }
  std::vector<Picture> pictures = figure.pictures;
  pictures.insert(pictures.end(), figure.goldens.begin(), figure.goldens.end());
  for (const Picture& picture : pictures) {
    if (!unavailable(picture).empty()) continue;
    if (picture.look == Look::predicted) {
      all.push_back(uniform(picture));
      continue;
    }
    const std::vector<Unit> of_picture = units(figure, picture);
    all.insert(all.end(), of_picture.begin(), of_picture.end());
  }
  return all;
}

std::vector<Measurement> Plan::of_scenes(const Figure& figure) const {
  std::vector<Measurement> all;
  const bool is_draft = quality_ == Quality::draft;
  const double seconds = is_draft ? figure.seconds / kDraftSeconds : figure.seconds;
  const measure::Spec spec = is_draft ? draft({}) : measure::Spec{};
  for (const std::string& scene : figure.scenes) {
    Measurement each{"converge", scenes_.path(scene), {}, seconds, nullptr, {}};
    if (codes_.accuracy) each.code = &*codes_.accuracy;
    if (codes_.several && figure.kind == "converge") each.code = &*codes_.several;
    each.options = {"--lambertian",
                    "--seconds",
                    fmt::format("{:g}", seconds),
                    "-r",
                    std::to_string(spec.width),
                    std::to_string(spec.height)};
    if (const std::string camera = scenes_.camera(scene); camera != "course") {
      each.options.insert(each.options.end(), {"--camera", camera});
    }
    if (is_draft) each.options.insert(each.options.end(), {"--pixels", "600"});
    if (figure.kind != "converge") {
      each.command = "cheapest";
      const double error = is_draft ? kDraftSize * figure.error : figure.error;
      each.options.insert(each.options.end(), {"--error", fmt::format("{:g}", error)});
    }
    all.push_back(std::move(each));
  }
  return all;
}

Measurement Plan::of_curve(const Figure& figure) const {
  const std::string task = task_of(figure);
  Measurement each{"stability", "", {task}, figure.seconds, nullptr, {}};
  if (codes_.stability) {
    each.code = &*codes_.stability;
    each.depends = each.code->hash.at(task);
  }
  // Grey lines only make a chart fuller.
  each.options.push_back("--no-variants");
  if (quality_ == Quality::draft) {
    each.seconds /= kDraftCurves;
    each.options.insert(each.options.end(), {"--coarse", "--effort", "0.05"});
  }
  return each;
}

std::vector<Measurement> Plan::of_prices(const Figure& figure) const {
  if (!codes_.measure) return {};
  std::set<std::string> ways;
  const bool is_draft = quality_ == Quality::draft;
  for (const Price& price : figure.prices) {
    if (is_draft && !price.task.starts_with("hit_")) continue;  // others take seconds each
    for (const std::string& way : {price.plain, price.remedy}) {
      if (way != kReference) ways.insert(price.task + "." + way);
    }
  }
  const double seconds = is_draft ? 1 : figure.seconds;
  Measurement each{"measure", "", {ways.begin(), ways.end()}, seconds, &*codes_.measure, {}};
  each.depends = each.code->hash.at("framework");
  each.options.insert(each.options.end(), {"--seconds", fmt::format("{:g}", seconds)});
  return {each};
}

// A ray needs no light, so that its figure can be made when the tasks of parts 1 and 2 are written.
Measurement Plan::of_view(const Figure& figure) const {
  measure::Spec spec;
  spec.engine = pt::Engine::task;
  spec.path.to = figure.kind == "ray" ? 0 : 5;
  const std::string scene = figure.scenes.at(0);
  Measurement each{"view", scenes_.path(scene), {}, figure.seconds, nullptr, {}, {}};
  each.options = {"--lambertian",
                  "-m",
                  std::to_string(spec.path.to),
                  "-r",
                  std::to_string(figure.size[0]),
                  std::to_string(figure.size[1]),
                  "--pixel",
                  std::to_string(figure.pixel[0]),
                  std::to_string(figure.pixel[1])};
  if (codes_.view) {
    each.code = &*codes_.view;
    each.depends = identity(*each.code, spec);
    each.obstacle = obstacle(*each.code, spec);
  }
  return each;
}

std::vector<Measurement> Plan::measurements(const Figure& figure) const {
  if (figure.kind == "pictures" || figure.kind == "speedup" || figure.kind == "rules") return {};
  if (figure.kind == "path" || figure.kind == "ray") return {of_view(figure)};
  if (figure.kind == "curve") return {of_curve(figure)};
  return figure.kind == "prices" ? of_prices(figure) : of_scenes(figure);
}

double Plan::seconds(const Figure& figure) const {
  std::set<std::string> keys;
  double sum = 0;
  for (const Unit& unit : units(figure)) {
    if (keys.insert(store_.key(unit)).second) sum += store_.seconds(unit);
  }
  for (const Measurement& each : measurements(figure)) sum += measured_.cpu_seconds(each);
  return sum;
}

}  // namespace writeup
