// Reads back what export writes, by readers of its own that know only what pbrt's and Mitsuba's manuals say of their formats.
#include "pt/scene/export/export.h"

#include "pt/error.h"
#include "pt/scene/frame_camera.h"
#include "pt/scene/load_collada.h"
#include "pt/tasks/camera_ray.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tinyxml2.h>

namespace pt {
namespace {

using Numbers = std::vector<double>;

// A scene as lines, in no order: shapes with their albedo and emission, lights.
using Lines = std::multiset<std::string>;

std::string line(const char* kind, const std::vector<Numbers>& parts) {
  std::string text = kind;
  for (const Numbers& part : parts) {
    for (const double number : part) text += fmt::format(" {:.7g}", number + 0.0);
  }
  return text;
}
Numbers list(Vec3 v) { return {v.x, v.y, v.z}; }
Numbers list(Rgb c) { return {c.r, c.g, c.b}; }

// Normals count where they are written: at smooth corners.
std::string triangle_line(const Numbers& p, const Numbers& n, const Numbers& albedo,
                          const Numbers& emission) {
  return line("triangle", {p, n, albedo, emission});
}

bool is_flat(const Triangle& t) {
  const Vec3 n = normalize(geometric_normal(t));
  return std::min({dot(n, t.n0), dot(n, t.n1), dot(n, t.n2)}) > 1 - 1e-9;
}

Lines lines_of(const Scene& scene) {
  Lines all;
  for (int i = 0; i < scene.primitives.size(); ++i) {
    const Material& of = scene.materials[scene.material_of[i]];
    if (!scene.primitives.is_triangle(i)) {
      const Sphere& s = scene.primitives.sphere(i);
      all.insert(line("sphere", {list(s.center), {s.radius}, list(of.albedo), list(of.emission)}));
      continue;
    }
    const Triangle& t = scene.primitives.triangle(i);
    Numbers p, n;
    for (const Vec3 v : {t.p0, t.p1, t.p2}) p.insert(p.end(), {v.x, v.y, v.z});
    for (const Vec3 v : {t.n0, t.n1, t.n2}) n.insert(n.end(), {v.x, v.y, v.z});
    all.insert(triangle_line(p, is_flat(t) ? Numbers{} : n, list(of.albedo), list(of.emission)));
  }
  for (const Light& light : scene.lights) {
    if (const auto* point = std::get_if<PointLight>(&light)) {
      all.insert(line("point", {list(point->position), list(point->intensity)}));
    } else if (const auto* sun = std::get_if<DirectionalLight>(&light)) {
      all.insert(line("directional", {list(sun->direction), list(sun->irradiance)}));
    }
  }
  return all;
}

Numbers numbers(std::string text) {
  for (char& c : text) {
    if (c == ',' || c == '[' || c == ']') c = ' ';
  }
  std::istringstream in(text);
  Numbers all;
  for (double number = 0; in >> number;) all.push_back(number);
  return all;
}

// A scene as a reader finds it: the things, and the direction through a point of the picture, (0, 0) at the bottom left.
struct ReadBack {
  Lines lines;
  Numbers position, right, up, forward;  // of the camera
  double tan_h = 0, tan_v = 0;

  Vec3 direction(double x, double y) const {
    const double u = (2 * x - 1) * tan_h, v = (2 * y - 1) * tan_v;
    const auto along = [&](int i) { return right[i] * u + up[i] * v + forward[i]; };
    return normalize({along(0), along(1), along(2)});
  }
};

struct Loaded {
  LoadedScene file;
  Camera camera;
  ExportedView view() const { return {file.scene, camera, 96, 72, 5, 64}; }
};

Loaded load(const std::string& name) {
  Loaded loaded{load_collada(fmt::format("{}/scenes/{}.dae", FIRSTLIGHT_ROOT, name)), {}};
  loaded.camera = frame_camera(loaded.file, Framing::file, 96, 72);
  return loaded;
}

// The words of pbrt's language: quoted strings, and lists in brackets, are one word.
std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> words;
  for (std::size_t at = text.find_first_not_of(" \n"); at != text.npos;
       at = text.find_first_not_of(" \n", at)) {
    const char close = text[at] == '"' ? '"' : text[at] == '[' ? ']' : ' ';
    std::size_t end = close == ' ' ? text.find_first_of(" \n", at) : text.find(close, at + 1) + 1;
    end = std::min(end, text.size());
    words.push_back(text.substr(at, end - at));
    at = end;
  }
  return words;
}

class PbrtReader {
 public:
  explicit PbrtReader(const std::string& text) : words_(words_of(text)) {
    while (at_ < words_.size()) directive(words_[at_++]);
  }
  ReadBack read;

 private:
  std::map<std::string, std::string> parameters() {
    std::map<std::string, std::string> all;
    while (at_ + 1 < words_.size() && words_[at_][0] == '"') {
      all[words_[at_].substr(1, words_[at_].size() - 2)] = words_[at_ + 1];
      at_ += 2;
    }
    return all;
  }

  void directive(const std::string& name) {
    if (name == "Transform") return camera_from(numbers(words_[at_++]));
    if (name == "AttributeBegin") return emission_ = {0, 0, 0}, center_ = {0, 0, 0}, void();
    if (name == "AttributeEnd" || name == "WorldBegin") return;
    if (name == "Translate") {
      for (double& each : center_) each = std::stod(words_[at_++]);
      return;
    }
    const std::string kind = words_[at_++];
    auto given = parameters();
    const auto list_of = [&](const char* key) { return numbers(given[key]); };
    if (name == "Camera") {
      read.tan_v = std::tan(list_of("float fov")[0] * kPi / 360);
      read.tan_h = read.tan_v * 96 / 72;
    }
    if (name == "Material") albedo_ = list_of("rgb reflectance");
    if (name == "AreaLightSource") emission_ = list_of("rgb L");
    if (name == "LightSource" && kind == "\"point\"") {
      read.lines.insert(line("point", {list_of("point3 from"), list_of("rgb I")}));
    }
    if (name == "LightSource" && kind == "\"distant\"") {
      read.lines.insert(line("directional", {list_of("point3 to"), list_of("rgb L")}));
    }
    if (name == "Shape" && kind == "\"sphere\"") {
      read.lines.insert(line("sphere", {center_, list_of("float radius"), albedo_, emission_}));
    }
    if (name == "Shape" && kind == "\"trianglemesh\"") {
      const Numbers p = list_of("point3 P"), n = list_of("normal N");
      const Numbers index = list_of("integer indices");
      for (std::size_t i = 0; i < index.size(); i += 3) {
        Numbers corners, normals;
        for (std::size_t k = i; k < i + 3; ++k) {
          const std::size_t first = 3 * static_cast<std::size_t>(index[k]);
          corners.insert(corners.end(), p.begin() + first, p.begin() + first + 3);
          if (!n.empty()) normals.insert(normals.end(), n.begin() + first, n.begin() + first + 3);
        }
        read.lines.insert(triangle_line(corners, normals, albedo_, emission_));
      }
    }
  }

  // The matrix takes the world into the camera's space, column by column; there x is to the right, y up, z forward.
  void camera_from(const Numbers& m) {
    read.right = {m[0], m[4], m[8]};
    read.up = {m[1], m[5], m[9]};
    read.forward = {m[2], m[6], m[10]};
    for (int i = 0; i < 3; ++i) {
      read.position.push_back(
          -(m[12] * read.right[i] + m[13] * read.up[i] + m[14] * read.forward[i]));
    }
  }

  std::vector<std::string> words_;
  std::size_t at_ = 0;
  Numbers albedo_, emission_{0, 0, 0}, center_{0, 0, 0};
};

class MitsubaReader {
 public:
  explicit MitsubaReader(const MitsubaScene& scene) : scene_(scene) {
    document_.Parse(scene.xml.c_str());
    EXPECT_FALSE(document_.Error()) << document_.ErrorStr();
    const Element* root = document_.RootElement();
    for (const Element* e = root->FirstChildElement(); e != nullptr; e = e->NextSiblingElement()) {
      const std::string kind = e->Name(),
                        type = e->Attribute("type") == nullptr ? "" : e->Attribute("type");
      if (kind == "bsdf")
        albedo_[e->Attribute("id")] = value(e->FirstChildElement("bsdf"), "reflectance");
      if (kind == "sensor") camera_from(e);
      if (kind == "shape") shape(e, type);
      if (type == "point")
        read.lines.insert(line("point", {value(e, "position"), value(e, "intensity")}));
      if (type == "directional") {
        read.lines.insert(line("directional", {value(e, "direction"), value(e, "irradiance")}));
      }
    }
  }
  ReadBack read;

 private:
  using Element = tinyxml2::XMLElement;

  static std::string attribute(const Element* parent, const std::string& name) {
    for (const Element* e = parent->FirstChildElement(); e != nullptr;
         e = e->NextSiblingElement()) {
      if (e->Attribute("name") != nullptr && name == e->Attribute("name"))
        return e->Attribute("value");
    }
    return "";
  }
  static Numbers value(const Element* parent, const std::string& name) {
    return numbers(attribute(parent, name));
  }

  // The matrix takes the camera's space into the world, row by row; there x is to the left, y up, z forward.
  void camera_from(const Element* sensor) {
    const Numbers m = numbers(
        sensor->FirstChildElement("transform")->FirstChildElement("matrix")->Attribute("value"));
    read.right = {-m[0], -m[4], -m[8]};
    read.up = {m[1], m[5], m[9]};
    read.forward = {m[2], m[6], m[10]};
    read.position = {m[3], m[7], m[11]};
    EXPECT_EQ(attribute(sensor, "fov_axis"), "x");
    read.tan_h = std::tan(value(sensor, "fov")[0] * kPi / 360);
    read.tan_v = read.tan_h * 72 / 96;
  }

  void shape(const Element* e, const std::string& type) {
    const Numbers albedo = albedo_[e->FirstChildElement("ref")->Attribute("id")];
    const Element* emitter = e->FirstChildElement("emitter");
    const Numbers emission = emitter == nullptr ? Numbers{0, 0, 0} : value(emitter, "radiance");
    if (type == "sphere") {
      read.lines.insert(line("sphere", {value(e, "center"), value(e, "radius"), albedo, emission}));
      return;
    }
    mesh(scene_.meshes.at(attribute(e, "filename")), albedo, emission);
  }

  void mesh(const std::string& ply, const Numbers& albedo, const Numbers& emission) {
    std::istringstream in(ply.substr(ply.find("end_header") + 11));
    const bool smooth = ply.find("property float nx") != ply.npos;
    std::vector<Numbers> corners;
    std::string text;
    for (std::size_t left = std::stoul(ply.substr(ply.find("vertex ") + 7)); left > 0; --left) {
      std::getline(in, text);
      corners.push_back(numbers(text));
    }
    while (std::getline(in, text)) {
      const Numbers face = numbers(text);
      Numbers p, n;
      for (int i = 1; i <= 3; ++i) {
        const Numbers& corner = corners.at(static_cast<std::size_t>(face[i]));
        p.insert(p.end(), corner.begin(), corner.begin() + 3);
        if (smooth) n.insert(n.end(), corner.begin() + 3, corner.end());
      }
      read.lines.insert(triangle_line(p, n, albedo, emission));
    }
  }

  const MitsubaScene& scene_;
  tinyxml2::XMLDocument document_;
  std::map<std::string, Numbers> albedo_;
};

void expect_same(const ReadBack& read, const Loaded& loaded) {
  EXPECT_EQ(read.lines, lines_of(loaded.file.scene));
  for (const auto& [x, y] : {std::pair{.1, .2}, {.9, .3}, {.5, .8}}) {
    const Ray ray = camera_ray(loaded.camera, x, y);
    EXPECT_LT(length(ray.direction - read.direction(x, y)), 1e-9);
  }
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(read.position[i], loaded.camera.position[i], 1e-9);
}

class AScene : public testing::TestWithParam<const char*> {};

TEST_P(AScene, is_the_same_in_pbrts_words) {
  const Loaded loaded = load(GetParam());
  expect_same(PbrtReader(to_pbrt(loaded.view())).read, loaded);
}

TEST_P(AScene, is_the_same_in_mitsubas_words) {
  const Loaded loaded = load(GetParam());
  const MitsubaScene scene = to_mitsuba(loaded.view());
  expect_same(MitsubaReader(scene).read, loaded);
}

INSTANTIATE_TEST_SUITE_P(of_ours, AScene,
                         testing::Values("box_spheres", "vase", "smooth_normals", "glowing_sphere",
                                         "point_light", "directional_light", "camera_turned"));

TEST(export_scene, refuses_lights_that_the_format_has_not) {
  const Loaded loaded = load("floor_under_sky");
  for (const SceneFormat format : {SceneFormat::pbrt, SceneFormat::mitsuba, SceneFormat::blender}) {
    EXPECT_THROW(export_scene(loaded.view(), format, testing::TempDir(), "floor"), Error);
  }
  EXPECT_THAT(to_plain(loaded.view()), testing::HasSubstr("\nsky "));
}

}  // namespace
}  // namespace pt
