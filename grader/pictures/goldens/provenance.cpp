#include "grader/pictures/goldens/provenance.h"

#include "grader/base/sha256.h"
#include "pt/error.h"
#include "pt/file.h"

#include <cmath>
#include <map>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace grader::pictures {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMaxFileBytes = std::size_t{1} << 29;
constexpr std::size_t kMaxBytes = 1 << 20;

const char* framing_name(pt::Framing framing) {
  switch (framing) {
    case pt::Framing::course:
      return "course";
    case pt::Framing::fit:
      return "fit";
    case pt::Framing::file:
      break;
  }
  return "file";
}

const std::map<pt::LightChoice, const char*> kLightOf{{pt::LightChoice::file, ""},
                                                      {pt::LightChoice::course, " course light"},
                                                      {pt::LightChoice::sky, " sky"},
                                                      {pt::LightChoice::camera, " camera light"}};

}  // namespace

std::string recipe_settings(const Recipe& recipe) {
  const pt::PathSettings& settings = recipe.settings;
  Json json{{"scene", recipe.scene.filename().string()},
            {"camera", framing_name(recipe.framing)},
            {"size", {recipe.width, recipe.height}}};
  if (settings.show_normals) {
    json["normals"] = true;
  } else {
    json["bounces"] = {settings.from, settings.to};
    json["direct"] =
        settings.direct == pt::PathSettings::Direct::hemisphere ? "hemisphere" : "lights";
    json["light_samples"] = settings.light_samples;
    json["survival"] = settings.survival;
  }
  if (recipe.adaptive) {
    json["adaptive"] = {{"max_samples", recipe.adaptive->max_samples},
                        {"batch", recipe.adaptive->batch},
                        {"tolerance", recipe.adaptive->tolerance}};
  }
  return json.dump();
}

std::string picture_hash(const Recipe& recipe) {
  const std::string scene = base::sha256(pt::read_file(recipe.scene, kMaxFileBytes));
  const std::string load = fmt::format("{}{}{}", recipe.load.lambertian ? " lambertian" : "",
                                       recipe.load.common_emission ? " common emission" : "",
                                       kLightOf.at(recipe.load.light));
  return base::sha256(recipe_settings(recipe) + scene + load);
}

void write_provenance(const std::filesystem::path& file, const Provenance& from) {
  Json json{{"recipe", from.recipe},
            {"command", from.command},
            {"commit", from.commit},
            {"first_seed", fmt::format("{:#x}", from.first_seed)},
            {"parts", from.parts},
            {"samples", from.samples},
            {"cpu_seconds", std::round(from.cpu_seconds * 10) / 10}};
  if (!from.because.empty()) json["because"] = from.because;
  json["settings"] = Json::parse(from.settings);
  json["sha256"] = from.sha256;
  json["files_sha256"] = from.files;
  pt::write_file(file, json.dump(1) + "\n");
}

Provenance read_provenance(const std::filesystem::path& file) {
  const std::string text = pt::read_file(file, kMaxBytes);
  try {
    const Json json = Json::parse(text);
    Provenance provenance;
    json.at("recipe").get_to(provenance.recipe);
    json.at("command").get_to(provenance.command);
    json.at("commit").get_to(provenance.commit);
    provenance.first_seed = std::stoull(json.at("first_seed").get<std::string>(), nullptr, 0);
    json.at("parts").get_to(provenance.parts);
    json.at("samples").get_to(provenance.samples);
    json.at("cpu_seconds").get_to(provenance.cpu_seconds);
    provenance.because = json.value("because", "");
    provenance.settings = json.at("settings").dump();
    json.at("sha256").get_to(provenance.sha256);
    json.at("files_sha256").get_to(provenance.files);
    return provenance;
  } catch (const std::exception& error) {
    throw pt::Error(
        fmt::format("{}: this does not say where a golden comes from ({}); make it again "
                    "with ./run bless",
                    file.string(), error.what()));
  }
}

GoldenFiles golden_files(const std::filesystem::path& folder, const std::string& recipe) {
  return {folder / (recipe + ".exr"), folder / (recipe + ".json"),
          folder / (recipe + "_rates.json")};
}

std::string hash_of(const GoldenFiles& files) {
  std::string bytes = pt::read_file(files.film, kMaxFileBytes);
  if (std::filesystem::exists(files.rates)) bytes += pt::read_file(files.rates, kMaxFileBytes);
  return base::sha256(bytes);
}

void expect_as_made(const GoldenFiles& files) {
  if (!std::filesystem::exists(files.film)) return;
  if (read_provenance(files.provenance).files == hash_of(files)) return;
  const std::string folder = files.film.parent_path().filename().string();
  throw pt::Error(fmt::format(
      "{}/{} is not the golden that was made: get it back (git checkout {}), or make it "
      "again (./run bless {})",
      folder, files.film.filename().string(), folder, files.film.stem().string()));
}

}  // namespace grader::pictures
