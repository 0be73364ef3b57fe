#include "writeup/catalogue.h"

#include "pt/error.h"
#include "pt/file.h"

#include <set>

namespace writeup {

using nlohmann::json;

namespace {

constexpr std::size_t kMaxCatalogue = std::size_t{1} << 22;

const std::set<std::string> kSettings{
    "id",     "label",    "scene",         "size",     "frame",      "samples", "adaptive", "seed",
    "engine", "normals",  "light_samples", "survival", "hemisphere", "bounces", "look",     "crop",
    "camera", "exposure", "mistake",       "time_of",  "in_bounces", "show"};
const std::set<std::string> kFigure{"id",     "part",      "title",    "kind",     "caption",
                                    "flip",   "small",     "settings", "pictures", "golden",
                                    "scenes", "file",      "seconds",  "error",    "curve",
                                    "lines",  "threshold", "prices",   "pixel",    "size"};

void expect_known(const json& object, const std::set<std::string>& known) {
  for (const auto& [name, value] : object.items()) {
    if (!known.contains(name)) throw pt::Error("unknown field '" + name + "'");
  }
}

Look look_of(const std::string& word) {
  static const std::map<std::string, Look> looks{{"radiance", Look::radiance},
                                                 {"rates", Look::rates},
                                                 {"boxes", Look::boxes},
                                                 {"predicted", Look::predicted},
                                                 {"error", Look::error}};
  const auto found = looks.find(word);
  if (found == looks.end()) throw pt::Error("there is no look '" + word + "'");
  return found->second;
}

// [left, top, width, height].
Crop crop_from(const json& in) {
  const Crop crop{in.at(0), in.at(1), in.at(2), in.at(3)};
  const bool inside = crop.left >= 0 && crop.top >= 0 && crop.width > 0 && crop.height > 0 &&
                      crop.left + crop.width <= 1 && crop.top + crop.height <= 1;
  if (!inside) throw pt::Error("'crop' is not a part of the picture: numbers from 0 to 1");
  return crop;
}

constexpr int kGoldenSeeds[] = {1001, 1002};  // no picture has them

// Default settings of a picture.
json defaults() {
  measure::Spec spec;
  spec.path.to = 5;
  json all = to_json(spec);
  all["show"] = "full";
  return all;
}

// "show" in the words of ./run render, as a range of bounces.
void apply_show(const std::string& show, json& settings) {
  const int most = settings.at("bounces").at(1);
  if (show == "normals") settings["normals"] = true;
  if (show == "direct") settings["bounces"] = {1, 1};
  if (show == "indirect") settings["bounces"] = {2, most};
  if (show != "full" && show != "normals" && show != "direct" && show != "indirect") {
    throw pt::Error("there is nothing called '" + show + "' to show");
  }
}

Picture picture_from(const json& figure, const json& own, const json& defaults) {
  json all = defaults;
  if (figure.contains("settings")) all.update(figure.at("settings"));
  all.update(own);
  expect_known(all, kSettings);
  if (all.at("bounces").is_number()) {
    const int most = all.at("bounces");
    all["bounces"] = {0, most};
  }
  apply_show(all.at("show"), all);
  if (all.contains("adaptive") && all.at("adaptive").is_array()) {
    all["adaptive"] = {{"batch", all["adaptive"][0]}, {"tolerance", all["adaptive"][1]}};
  }
  Picture picture;
  picture.id = all.value("id", "golden");
  picture.label = all.value("label", picture.id);
  picture.scene = all.at("scene");
  picture.spec = measure::spec_from_json(all);
  picture.look = look_of(all.value("look", "radiance"));
  if (all.contains("crop")) picture.crop = crop_from(all.at("crop"));
  picture.in_bounces = all.value("in_bounces", false);
  picture.exposure = all.value("exposure", 1.0);
  picture.mistake = all.value("mistake", "");
  picture.time_of = all.value("time_of", "");
  if (picture.in_bounces && picture.spec.adaptive) {
    throw pt::Error("'in_bounces' cannot be used with 'adaptive'");
  }
  return picture;
}

Figure figure_from(const json& in, const json& defaults) {
  expect_known(in, kFigure);
  Figure figure;
  figure.part = in.at("part");
  figure.title = in.at("title");
  figure.source = in.dump() + defaults.dump();
  figure.kind = in.value("kind", "pictures");
  figure.caption = in.value("caption", "");
  figure.file = in.value("file", "");
  figure.flip = in.value("flip", true);
  figure.small = in.value("small", false);
  figure.seconds = in.value("seconds", 0.0);
  figure.error = in.value("error", 0.0);
  figure.scenes = in.value("scenes", std::vector<std::string>{});
  figure.curve = in.value("curve", "");
  figure.threshold = in.value("threshold", 0.0);
  figure.lines = in.value("lines", std::vector<std::string>{});
  if (figure.kind == "path" || figure.kind == "ray") {
    figure.pixel = in.at("pixel");
    figure.size = in.at("size");
    if (figure.scenes.size() != 1) throw pt::Error("it is about one scene");
  }
  for (const json& price : in.value("prices", json::array())) {
    figure.prices.push_back({price.at("id"), price.at("failure"), price.at("task"),
                             price.at("plain"), price.at("remedy")});
  }
  for (const json& picture : in.value("pictures", json::array())) {
    figure.pictures.push_back(picture_from(in, picture, defaults));
  }
  for (const int seed : kGoldenSeeds) {
    if (!in.contains("golden")) break;
    json golden = in.at("golden");
    golden.update({{"seed", seed}, {"mistake", kReference}});
    figure.goldens.push_back(picture_from(in, golden, defaults));
    figure.goldens.back().golden = true;
  }
  return figure;
}

SceneSource scene_from(const json& in) {
  return {in.value("title", ""),       in.value("course", ""),   in.value("own", ""),
          in.value("mesh", ""),        in.value("triangles", 0), in.value("room", false),
          in.value("camera", "course")};
}

void expect_scenes(const Catalogue& catalogue, const Figure& figure) {
  std::vector<std::string> names = figure.scenes;
  for (const Picture& picture : figure.pictures) names.push_back(picture.scene);
  for (const std::string& name : names) {
    if (!catalogue.scenes.contains(name)) throw pt::Error("there is no scene '" + name + "'");
  }
}

}  // namespace

const Figure* Catalogue::find(const std::string& id) const {
  for (const Figure& figure : figures) {
    if (figure.id == id) return &figure;
  }
  return nullptr;
}

void add_codes(Catalogue& catalogue, const std::vector<std::string>& labels) {
  for (Figure& figure : catalogue.figures) {
    std::vector<Picture> all;
    for (const Picture& picture : figure.pictures) {
      all.push_back(picture);
      if (!picture.mistake.empty()) continue;
      all.back().label = std::string(kReference) + ": " + picture.label;
      for (const std::string& label : labels) {
        Picture other = picture;
        other.id += "_" + label;
        other.label = label + ": " + picture.label;
        other.mistake = other_code(label);
        if (!other.time_of.empty()) other.time_of += "_" + label;
        all.push_back(std::move(other));
      }
    }
    for (const std::string& label : labels) figure.source += label;
    figure.pictures = std::move(all);
  }
}

Catalogue read_catalogue(const std::filesystem::path& file) {
  Catalogue catalogue;
  std::string at = "it";
  try {
    const json in = json::parse(pt::read_file(file, kMaxCatalogue));
    for (const auto& [name, scene] : in.at("scenes").items()) {
      at = "scene " + name;
      catalogue.scenes[name] = scene_from(scene);
    }
    json all = defaults();
    all.update(in.value("defaults", json::object()));
    for (const json& entry : in.at("figures")) {
      at = "figure " + entry.value("id", "without an id");
      Figure figure = figure_from(entry, all);
      figure.id = entry.at("id");
      if (catalogue.find(figure.id) != nullptr) throw pt::Error("the name is used twice");
      expect_scenes(catalogue, figure);
      catalogue.figures.push_back(std::move(figure));
    }
  } catch (const std::exception& error) {
    throw pt::Error(file.string() + ": " + at + " cannot be used: " + error.what());
  }
  return catalogue;
}

}  // namespace writeup
