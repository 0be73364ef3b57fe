#include "scenes/collada_text.h"

#include "box_empty.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

namespace scenes {

using pt::Vec3;

namespace {

// A scene without surfaces, seen a little from above.
constexpr std::string_view kOpenScene =
    R"xml(<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
  <asset><up_axis>Y_UP</up_axis></asset>
  <library_lights>
    <light id="sky-light">
      <technique_common><ambient><color>.4 .4 .4</color></ambient></technique_common>
      <extra><technique profile="CGL">
        <ambient><color>.4 .4 .4</color></ambient>
      </technique></extra>
    </light>
    <light id="sun-light">
      <technique_common><directional><color>2 2 2</color></directional></technique_common>
      <extra><technique profile="CGL">
        <directional><color>2 2 2</color></directional>
      </technique></extra>
    </light>
  </library_lights>
  <library_cameras>
    <camera id="camera">
      <optics><technique_common><perspective>
        <xfov>65</xfov>
        <aspect_ratio>1.333333</aspect_ratio>
        <znear>.01</znear>
        <zfar>100</zfar>
      </perspective></technique_common></optics>
    </camera>
  </library_cameras>
  <library_effects>
  </library_effects>
  <library_materials>
  </library_materials>
  <library_geometries>
  </library_geometries>
  <library_visual_scenes>
    <visual_scene id="scene">
      <node name="camera">
        <translate>0 1.4 2.6</translate>
        <rotate>1 0 0 -20</rotate>
        <instance_camera url="#camera"/>
      </node>
      <node name="sky"><instance_light url="#sky-light"/></node>
      <node name="sun">
        <rotate>0 1 0 50</rotate>
        <rotate>1 0 0 -40</rotate>
        <instance_light url="#sun-light"/>
      </node>
    </visual_scene>
  </library_visual_scenes>
  <scene><instance_visual_scene url="#scene"/></scene>
</COLLADA>
)xml";

constexpr int kTriplesPerLine = 8;

// A text of numbers that grows at its end.
class Numbers {
 public:
  explicit Numbers(std::size_t expected_size) { text_.reserve(expected_size); }

  // As short as possible: no trailing zeros, and no minus before zero.
  void add(double value, int decimals) {
    std::array<char, 64> buffer;
    const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                      std::chars_format::fixed, decimals);
    std::string_view digits(buffer.data(), result.ptr - buffer.data());
    if (digits.find('.') != std::string_view::npos) {
      digits = digits.substr(0, digits.find_last_not_of('0') + 1);
      if (digits.back() == '.') digits.remove_suffix(1);
    }
    const bool negative = digits.front() == '-';
    if (negative) digits.remove_prefix(1);
    if (digits.size() > 1 && digits.front() == '0') digits.remove_prefix(1);
    if (negative && digits != "0") text_ += '-';
    text_ += digits;
  }

  void add(int value) {
    std::array<char, 16> buffer;
    const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    text_.append(buffer.data(), result.ptr);
  }

  void separate(char separator) { text_ += separator; }
  void end_triple(std::size_t index) { text_ += (index + 1) % kTriplesPerLine == 0 ? '\n' : ' '; }

  std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

std::string triples(const std::vector<Vec3>& values, int decimals) {
  Numbers numbers(values.size() * 3 * (decimals + 4));
  for (std::size_t i = 0; i < values.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      if (axis > 0) numbers.separate(' ');
      numbers.add(values[i][axis], decimals);
    }
    numbers.end_triple(i);
  }
  return numbers.take();
}

std::string triples(const std::vector<std::array<int, 3>>& values) {
  Numbers numbers(values.size() * 3 * 8);
  for (std::size_t i = 0; i < values.size(); ++i) {
    for (int corner = 0; corner < 3; ++corner) {
      if (corner > 0) numbers.separate(' ');
      numbers.add(values[i][corner]);
    }
    numbers.end_triple(i);
  }
  return numbers.take();
}

std::string number(double value, int decimals) {
  Numbers numbers(16);
  numbers.add(value, decimals);
  return numbers.take();
}

std::string source(const std::string& id, const std::vector<Vec3>& values, int decimals) {
  const std::string count = std::to_string(values.size());
  return "        <source id=\"" + id + "\">\n          <float_array id=\"" + id +
         "-array\" count=\"" + std::to_string(3 * values.size()) + "\">\n" +
         triples(values, decimals) +
         "</float_array>\n          <technique_common><accessor source=\"#" + id +
         "-array\" count=\"" + count + "\" stride=\"3\">\n" +
         R"xml(            <param name="X" type="float"/>
            <param name="Y" type="float"/>
            <param name="Z" type="float"/>
          </accessor></technique_common>
        </source>
)xml";
}

std::string geometry(const Mesh& mesh, int decimals) {
  return "    <geometry id=\"object\">\n      <mesh>\n" +
         source("object-points", mesh.points, decimals) +
         source("object-normals", mesh.normals, decimals - 1) +
         R"xml(        <vertices id="object-vertices">
          <input semantic="POSITION" source="#object-points"/>
        </vertices>
        <triangles material="object" count=")xml" +
         std::to_string(mesh.faces.size()) + R"xml(">
          <input semantic="VERTEX" source="#object-vertices" offset="0"/>
          <input semantic="NORMAL" source="#object-normals" offset="0"/>
          <p>
)xml" + triples(mesh.faces) +
         "</p>\n        </triangles>\n      </mesh>\n    </geometry>\n";
}

constexpr std::string_view kEffect = R"xml(    <effect id="object-effect">
      <profile_COMMON><technique sid="common"><lambert>
        <diffuse><color>.7 .7 .7 1</color></diffuse>
      </lambert></technique></profile_COMMON>
    </effect>
)xml";

constexpr std::string_view kMaterial =
    R"xml(    <material id="object-material"><instance_effect url="#object-effect"/></material>
)xml";

// The mesh is turned a little, so that a ring is not seen face on. It stands on the ground, within
// .7 of the room's middle, and is 1.1 high.
std::string node(const Mesh& mesh) {
  double radius = 0, bottom = pt::kInfinity, top = -pt::kInfinity;
  for (const Vec3& p : mesh.points) {
    radius = std::max(radius, std::hypot(p.x, p.z));
    bottom = std::min(bottom, p.y);
    top = std::max(top, p.y);
  }
  const double scale = std::min(0.7 / radius, 1.1 / (top - bottom));
  const std::string size = number(scale, 4);
  return "      <node name=\"object\">\n        <translate>0 " + number(-scale * bottom, 4) +
         " 0</translate>\n        <rotate>0 1 0 30</rotate>\n        <scale>" + size + " " + size +
         " " + size + R"xml(</scale>
        <instance_geometry url="#object">
          <bind_material><technique_common>
            <instance_material symbol="object" target="#object-material"/>
          </technique_common></bind_material>
        </instance_geometry>
      </node>
)xml";
}

}  // namespace

std::string collada_text(const Mesh& mesh, Setting setting, int decimals,
                         const std::string& comment) {
  std::string_view rest = setting == Setting::room ? kBoxEmpty : kOpenScene;
  rest.remove_prefix(rest.find("<COLLADA"));
  std::string text = "<!-- " + comment + " -->\n";
  const auto insert_before = [&](std::string_view end_tag, std::string_view what) {
    const std::size_t line = rest.rfind('\n', rest.find(end_tag)) + 1;
    text += rest.substr(0, line);
    text += what;
    rest.remove_prefix(line);
  };
  insert_before("</library_effects>", kEffect);
  insert_before("</library_materials>", kMaterial);
  insert_before("</library_geometries>", geometry(mesh, decimals));
  insert_before("</visual_scene>", node(mesh));
  text += rest;
  return text;
}

}  // namespace scenes
