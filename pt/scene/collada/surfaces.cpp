#include "pt/scene/collada/surfaces.h"

#include "pt/scene/collada/geometry.h"
#include "pt/scene/collada/materials.h"
#include "pt/scene/collada/place.h"
#include "pt/scene/collada/transforms.h"

#include <unordered_map>
#include <utility>

#include <tinyxml2.h>

namespace pt {

namespace {

constexpr std::size_t kMaxPrimitives = 10'000'000;

// The <instance_material> of a symbol. Where none has it, the only one there is serves all: a
// sphere has no symbol to bind, and some exporters bind another name.
const XMLElement* find_binding(const XMLElement& instance, const std::string& symbol) {
  const XMLElement* bind = instance.FirstChildElement("bind_material");
  const XMLElement* common = bind ? bind->FirstChildElement("technique_common") : nullptr;
  if (common == nullptr) return nullptr;
  const XMLElement* first = common->FirstChildElement("instance_material");
  for (const XMLElement* binding = first; binding != nullptr;
       binding = binding->NextSiblingElement("instance_material")) {
    const char* bound = binding->Attribute("symbol");
    if (bound != nullptr && symbol == bound) return binding;
  }
  const bool is_only = first && !first->NextSiblingElement("instance_material");
  return is_only ? first : nullptr;
}

Material default_material() {
  Material material;
  material.name = "default";
  return material;
}

class SurfaceReader {
 public:
  SurfaceReader(const ColladaDocument& document, const LoadOptions& options)
      : document_(document), options_(options) {}

  void add(const Instance& instance) {
    const XMLElement& element = document_.resolve(*instance.element, "url", "geometry");
    const ColladaGeometry& geometry = read(element);
    if (geometry.sphere_radius) {
      add_sphere(instance, *geometry.sphere_radius);
    } else {
      for (const MeshPart& part : geometry.parts) add_part(instance, part);
    }
  }

  // Primitives are all triangles, then all spheres.
  Surfaces take() {
    found_.material_of.insert(found_.material_of.end(), material_of_spheres_.begin(),
                              material_of_spheres_.end());
    if (without_area_ > 0) {
      found_.notes.push_back(std::to_string(without_area_) +
                             " triangles without an area are left out.");
    }
    if (without_material_ > 0) {
      found_.notes.push_back("surfaces without a material (" + std::to_string(without_material_) +
                             ", the first at node " + first_without_material_ +
                             ") have albedo 0.5.");
    }
    return std::move(found_);
  }

 private:
  const ColladaGeometry& read(const XMLElement& element) {
    const auto known = geometries_.find(&element);
    if (known != geometries_.end()) return known->second;
    ColladaGeometry geometry = read_geometry(document_, element);
    found_.notes.insert(found_.notes.end(), geometry.notes.begin(), geometry.notes.end());
    return geometries_.emplace(&element, std::move(geometry)).first->second;
  }

  // Counts what is left out as well: it costs time.
  void count(const Instance& instance, std::size_t more) {
    placed_ += more;
    if (placed_ > kMaxPrimitives) {
      document_.fail(*instance.element,
                     "the scene has more than 10 million surfaces; instance fewer");
    }
  }

  void check_bounds(const Instance& instance, const Box& box) const {
    if (!(max_abs(box.min) <= kMaxCoordinate && max_abs(box.max) <= kMaxCoordinate)) {
      document_.fail(*instance.element, "coordinates reach beyond 1e30; scale the scene down");
    }
  }

  void add_sphere(const Instance& instance, double radius) {
    count(instance, 1);
    const std::optional<Sphere> sphere = place_sphere(radius, instance.to_world);
    if (!sphere) {
      document_.fail(*instance.node, "sphere " + label(*instance.node) +
                                         " is scaled unevenly, sheared or to nothing; make its "
                                         "scale uniform, or make it a mesh");
    }
    check_bounds(instance, bounds(*sphere));
    const int material = material_index(instance, "");
    found_.primitives.spheres.push_back(*sphere);
    material_of_spheres_.push_back(material);
    const Rgb emission = found_.materials[material].emission;
    if (!is_black(emission)) {
      found_.emitters.push_back(sphere_emitter(*sphere, emission, label(*instance.node)));
    }
  }

  void add_part(const Instance& instance, const MeshPart& part) {
    count(instance, part.triangles.size());
    std::vector<Triangle> placed;
    placed.reserve(part.triangles.size());
    Box box;
    for (const FileTriangle& triangle : part.triangles) {
      for (const Vec3 p : triangle.p) box.grow(instance.to_world.point(p));
      if (const std::optional<Triangle> t = place(triangle, instance.to_world))
        placed.push_back(*t);
    }
    check_bounds(instance, box);
    without_area_ += part.triangles.size() - placed.size();
    if (placed.empty()) return;
    const int material = material_index(instance, part.material_symbol);
    found_.primitives.triangles.insert(found_.primitives.triangles.end(), placed.begin(),
                                       placed.end());
    found_.material_of.resize(found_.primitives.triangles.size(), material);
    const Rgb emission = found_.materials[material].emission;
    if (!is_black(emission)) add_emitter(placed, emission, label(*instance.node));
  }

  void add_emitter(const std::vector<Triangle>& triangles, Rgb emission, const std::string& name) {
    double agreement = 0;
    for (const Triangle& t : triangles) agreement += dot(geometric_normal(t), t.n0 + t.n1 + t.n2);
    if (agreement < 0) {
      found_.notes.push_back("emitting surface " + name +
                             " has normals against its winding order: it emits on the side of the "
                             "winding order.");
    }
    found_.emitters.push_back(mesh_emitter(triangles, emission, name));
  }

  int material_index(const Instance& instance, const std::string& symbol) {
    const XMLElement* binding = find_binding(*instance.element, symbol);
    if (binding == nullptr && without_material_++ == 0) {
      first_without_material_ = label(*instance.node);
    }
    const XMLElement* element =
        binding ? &document_.resolve(*binding, "target", "material") : nullptr;
    const auto known = materials_.find(element);
    if (known != materials_.end()) return known->second;
    found_.materials.push_back(element ? read_supported(*element) : default_material());
    const int index = static_cast<int>(found_.materials.size()) - 1;
    materials_.emplace(element, index);
    return index;
  }

  Material read_supported(const XMLElement& element) {
    Material material = read_material(document_, element, found_.notes);
    if (material.unsupported.empty()) return material;
    const std::string name = "material " + label(element) + " (" + material.unsupported + ")";
    if (options_.lambertian) {
      material.unsupported.clear();
      found_.notes.push_back(name + " is treated as a diffuse albedo of 0.5.");
    } else {
      found_.notes.push_back(name + " is outside the model: only its normals can be shown.");
    }
    return material;
  }

  const ColladaDocument& document_;
  const LoadOptions& options_;
  Surfaces found_;
  std::vector<int> material_of_spheres_;
  std::size_t placed_ = 0;
  std::size_t without_area_ = 0;
  std::size_t without_material_ = 0;
  std::string first_without_material_;
  std::unordered_map<const XMLElement*, ColladaGeometry> geometries_;
  std::unordered_map<const XMLElement*, int> materials_;
};

}  // namespace

Surfaces read_surfaces(const ColladaDocument& document, const std::vector<Instance>& geometries,
                       const LoadOptions& options) {
  SurfaceReader reader(document, options);
  for (const Instance& instance : geometries) reader.add(instance);
  return reader.take();
}

}  // namespace pt
