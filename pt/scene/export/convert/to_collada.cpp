#include "pt/error.h"
#include "pt/file.h"
#include "pt/geometry/box.h"
#include "pt/scene/export/convert/model.h"

#include <iterator>

#include <fmt/format.h>

namespace pt {

namespace {

using Text = std::back_insert_iterator<std::string>;

void write_source(Text out, const std::string& id, const std::vector<Vec3>& vectors) {
  fmt::format_to(out, "<source id=\"{0}\"><float_array id=\"{0}-a\" count=\"{1}\">", id,
                 3 * vectors.size());
  for (const Vec3 v : vectors) fmt::format_to(out, "{:.9g} {:.9g} {:.9g}\n", v.x, v.y, v.z);
  fmt::format_to(out,
                 "</float_array><technique_common><accessor source=\"#{}-a\" count=\"{}\" "
                 "stride=\"3\"><param name=\"X\" type=\"float\"/><param name=\"Y\" type=\"float\"/>"
                 "<param name=\"Z\" type=\"float\"/></accessor></technique_common></source>\n",
                 id, vectors.size());
}

void write_geometry(Text out, const ModelMesh& mesh, std::size_t i) {
  fmt::format_to(out, "<geometry id=\"model{0}\"><mesh>\n", i);
  write_source(out, fmt::format("model{}-p", i), mesh.p);
  if (!mesh.n.empty()) write_source(out, fmt::format("model{}-n", i), mesh.n);
  fmt::format_to(out,
                 "<vertices id=\"model{0}-v\"><input semantic=\"POSITION\" source=\"#model{0}-p\"/>"
                 "</vertices>\n<triangles count=\"{1}\" material=\"m\"><input semantic=\"VERTEX\" "
                 "source=\"#model{0}-v\" offset=\"0\"/>",
                 i, mesh.faces.size());
  if (!mesh.n.empty()) {
    fmt::format_to(out, "<input semantic=\"NORMAL\" source=\"#model{}-n\" offset=\"0\"/>", i);
  }
  fmt::format_to(out, "<p>");
  for (const auto& face : mesh.faces) {
    fmt::format_to(out, "{} {} {}\n", face[0], face[1], face[2]);
  }
  fmt::format_to(out, "</p></triangles></mesh></geometry>\n");
}

std::string libraries(const Model& model) {
  std::string effects, materials, geometries;
  for (std::size_t i = 0; i < model.meshes.size(); ++i) {
    const Rgb c = model.meshes[i].albedo;
    fmt::format_to(
        std::back_inserter(effects),
        "<effect id=\"model{}-e\"><profile_COMMON><technique sid=\"c\"><lambert><diffuse>"
        "<color>{:.6g} {:.6g} {:.6g} 1</color></diffuse></lambert></technique>"
        "</profile_COMMON></effect>\n",
        i, c.r, c.g, c.b);
    fmt::format_to(
        std::back_inserter(materials),
        "<material id=\"model{0}-m\"><instance_effect url=\"#model{0}-e\"/></material>\n", i);
    write_geometry(std::back_inserter(geometries), model.meshes[i], i);
  }
  return "<library_effects>\n" + effects + "</library_effects>\n<library_materials>\n" + materials +
         "</library_materials>\n<library_geometries>\n" + geometries + "</library_geometries>\n";
}

// Turned so that y is up, and in the box moved and scaled to stand in its middle, a metre wide or high.
std::string node(const Model& model, bool is_in_box, bool z_up) {
  Box box;
  for (const ModelMesh& mesh : model.meshes) {
    for (const Vec3 p : mesh.p) box.grow(z_up ? Vec3{p.x, p.z, -p.y} : p);
  }
  std::string text = "<node id=\"model\">";
  if (is_in_box) {
    const double size = max_abs(box.extent());
    const double scale = size > 0 ? 1 / size : 1;
    const Vec3 middle = box.center();
    fmt::format_to(std::back_inserter(text),
                   "<scale>{0:.9g} {0:.9g} {0:.9g}</scale><translate>{1:.9g} {2:.9g} {3:.9g}"
                   "</translate>",
                   scale, -middle.x, -box.min.y, -middle.z);
  }
  if (z_up) text += "<rotate>1 0 0 -90</rotate>";
  for (std::size_t i = 0; i < model.meshes.size(); ++i) {
    fmt::format_to(std::back_inserter(text),
                   "\n<instance_geometry url=\"#model{0}\"><bind_material><technique_common>"
                   "<instance_material symbol=\"m\" target=\"#model{0}-m\"/></technique_common>"
                   "</bind_material></instance_geometry>",
                   i);
  }
  return text + "</node>\n";
}

std::string insert_before(const std::string& text, const std::string& mark,
                          const std::string& more) {
  const std::size_t at = text.find(mark);
  if (at == text.npos) throw Error("scenes/box_empty.dae has no " + mark + "; restore it");
  return text.substr(0, at) + more + text.substr(at);
}

}  // namespace

std::string to_collada(const Model& model, Surroundings around, bool z_up) {
  std::string outside =
      "<?xml version=\"1.0\"?>\n<COLLADA xmlns=\"http://www.collada.org/2005/11/COLLADASchema\" "
      "version=\"1.4.1\">\n<asset><up_axis>Y_UP</up_axis></asset>\n<library_visual_scenes>"
      "<visual_scene id=\"scene\">\n</visual_scene></library_visual_scenes>\n"
      "<scene><instance_visual_scene url=\"#scene\"/></scene>\n</COLLADA>\n";
  if (around == Surroundings::box) {
    outside = read_file(FIRSTLIGHT_ROOT "/scenes/box_empty.dae");
  } else if (around == Surroundings::sky) {
    outside = insert_before(outside, "<library_visual_scenes>",
                            "<library_lights><light id=\"sky\"><technique_common><ambient><color>1 "
                            "1 1</color></ambient></technique_common></light></library_lights>\n");
    outside =
        insert_before(outside, "</visual_scene>", "<node><instance_light url=\"#sky\"/></node>\n");
  }
  outside = insert_before(outside, "<library_visual_scenes>", libraries(model));
  return insert_before(outside, "</visual_scene>", node(model, around == Surroundings::box, z_up));
}

}  // namespace pt
