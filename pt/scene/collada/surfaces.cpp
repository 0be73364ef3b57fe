#include "pt/scene/collada/surfaces.h"

#include "pt/geometry/sphere.h"
#include "pt/geometry/triangle.h"
#include "pt/math/transform.h"
#include "pt/scene/collada/geometry.h"
#include "pt/scene/collada/lights.h"
#include "pt/scene/collada/materials.h"
#include "pt/scene/collada/transforms.h"
#include "pt/scene/collada/twins.h"

#include <cmath>
#include <optional>
#include <span>
#include <unordered_map>
#include <utility>

#include <tinyxml2.h>

namespace pt {

namespace {

constexpr std::size_t kMaxPrimitives = 10'000'000;

// Copies of surfaces that a file writes only once: a few lines can make any number of copies.
constexpr std::size_t kMaxCopies = 2'000'000;

// The materials that an <instance_geometry> binds to the symbols of its mesh. A part whose symbol is
// not bound gets the only binding: a sphere has no symbol, and some exporters bind another name.
struct Bindings {
  std::unordered_map<std::string, const XMLElement*> by_symbol;
  const XMLElement* only = nullptr;
};

Bindings read_bindings(const XMLElement& instance) {
  const XMLElement* common = find_below(&instance, {"bind_material", "technique_common"});
  if (common == nullptr) return {};
  Bindings bindings;
  const std::vector<const XMLElement*> all = children(*common, "instance_material");
  if (all.size() == 1) bindings.only = all[0];
  for (const XMLElement* binding : all) {
    bindings.by_symbol.emplace(attribute(binding, "symbol"), binding);
  }
  return bindings;
}

// A triangle of a file moved to the world. If the map mirrors, the corners change order, so that
// the geometric normal stays on the same side of the surface. A corner normal that is zero, or
// becomes zero, is replaced by the face's. Nothing if the moved triangle has no area (the square of
// its edges' cross product underflows or overflows).
std::optional<Triangle> place(const FileTriangle& triangle, const Transform& to_world) {
  const bool mirrors = to_world.determinant() < 0;
  const int order[3] = {0, mirrors ? 2 : 1, mirrors ? 1 : 2};
  Triangle placed;
  placed.p0 = to_world.point(triangle.p[order[0]]);
  placed.p1 = to_world.point(triangle.p[order[1]]);
  placed.p2 = to_world.point(triangle.p[order[2]]);
  const Vec3 geometric = geometric_normal(placed);
  if (!std::isnormal(length_squared(geometric))) return std::nullopt;
  const Vec3 face = normalize(geometric);
  const auto unit_normal = [&](int corner) {
    // Two steps, so that neither tiny normals nor tiny scales underflow.
    const Vec3 local = triangle.n[order[corner]];
    if (!std::isnormal(length_squared(local))) return face;
    const Vec3 n = to_world.normal(normalize(local));
    if (!std::isnormal(length_squared(n))) return face;
    return mirrors ? -normalize(n) : normalize(n);
  };
  placed.n0 = unit_normal(0);
  placed.n1 = unit_normal(1);
  placed.n2 = unit_normal(2);
  return placed;
}

// A sphere around the origin moved to the world. Nothing if the map is not a uniform scaling,
// rotation and mirroring: the axes differ in length, or from right angles, by more than 1e-5.
std::optional<Sphere> place_sphere(double radius, const Transform& to_world) {
  constexpr double kTolerance = 1e-5;
  const Vec3 axes[3] = {to_world.x, to_world.y, to_world.z};
  const double scale = std::cbrt(std::abs(to_world.determinant()));
  for (int i = 0; i < 3; ++i) {
    if (!(std::abs(length(axes[i]) - scale) <= kTolerance * scale)) return std::nullopt;
    if (!(std::abs(dot(axes[i], axes[(i + 1) % 3])) <= kTolerance * scale * scale)) {
      return std::nullopt;
    }
  }
  if (!std::isnormal(scale * radius)) return std::nullopt;
  return Sphere{to_world.translation, scale * radius};
}

class SurfaceReader {
 public:
  SurfaceReader(const Document& document, const LoadOptions& options)
      : document_(document), options_(options) {}

  // Reads the geometry, and counts its surfaces. Surfaces that are left out later count too,
  // because they cost time.
  void read(const Instance& instance) {
    const auto [known, is_new] = geometries_.try_emplace(instance.target);
    Geometry& geometry = known->second;
    if (is_new) geometry = read_geometry(document_, *instance.target);
    std::size_t more = geometry.sphere_radius ? 1 : 0;
    for (const MeshPart& part : geometry.parts) more += part.size();
    placed_ += more;
    if (placed_ > kMaxPrimitives) {
      document_.fail(*instance.element, "the scene has more than 10 million surfaces; use fewer");
    }
    if (!is_new) copies_ += more;
    if (copies_ > kMaxCopies) {
      document_.fail(*instance.element,
                     "more than 2 million surfaces of the scene are shown again by an instance of "
                     "the same geometry; use fewer");
    }
  }

  // Places what was read. A triangle takes 144 bytes, and ten million of them are stored once.
  void place_all(const std::vector<Instance>& instances) {
    scene_.primitives.triangles.reserve(placed_);
    scene_.material_of.reserve(placed_);
    for (const Instance& instance : instances) {
      const Geometry& geometry = geometries_.at(instance.target);
      if (geometry.sphere_radius) add_sphere(instance, *geometry.sphere_radius);
      for (const MeshPart& part : geometry.parts) add_part(instance, part);
    }
  }

  // Primitives are all triangles, then all spheres.
  Surfaces take() {
    scene_.material_of.insert(scene_.material_of.end(), material_of_spheres_.begin(),
                              material_of_spheres_.end());
    if (without_area_ > 0) {
      document_.note(std::to_string(without_area_) + " triangles without an area are left out.");
    }
    if (without_material_ > 0) {
      document_.note("surfaces without a material (" + std::to_string(without_material_) +
                     ", the first at node " + first_without_material_ + ") have albedo 0.5.");
    }
    merge();
    return std::move(found_);
  }

 private:
  // Part of the primitives that emits, as one lamp. Spheres are counted among spheres.
  struct Lamp {
    const Instance* instance;
    bool is_sphere;
    std::size_t begin, end;
    Rgb emission;
  };

  // Lamps are made of what is still seen once surfaces in one place are one.
  void merge() {
    const Primitives before = lamps_.empty() ? Primitives{} : scene_.primitives;
    const std::size_t triangles = scene_.primitives.triangles.size();
    const Twins twins = merge_twins(scene_);
    for (const Lamp& lamp : lamps_) {
      const std::string name = label(*lamp.instance->node);
      if (lamp.is_sphere) {
        if (!twins.is_shown[triangles + lamp.begin]) continue;
        add_emitter(*lamp.instance,
                    sphere_emitter(before.spheres[lamp.begin], lamp.emission, name));
        continue;
      }
      std::vector<Triangle> shown;
      for (std::size_t i = lamp.begin; i < lamp.end; ++i) {
        if (twins.is_shown[i]) shown.push_back(before.triangles[i]);
      }
      if (!shown.empty()) add_emitter(*lamp.instance, mesh_emitter(shown, lamp.emission, name));
    }
    note_on(twins);
  }

  void note_on(const Twins& twins) const {
    if (twins.equal > 0) {
      document_.note(
          std::to_string(twins.equal) +
          " surfaces lie exactly on another one that faces the same way and are left out" +
          (twins.lamps > 0 ? ", " + std::to_string(twins.lamps) + " of them lamps on a lamp."
                           : "."));
    }
    if (twins.opposite > 0) {
      document_.note(
          std::to_string(twins.opposite) +
          " surfaces lie exactly on the back of another one: both are one surface, which "
          "shows the material of the side that is seen.");
    }
    if (const std::size_t overlaps = count_overlaps(scene_.primitives); overlaps > 0) {
      document_.note(std::to_string(overlaps) +
                     " triangles have another one in their plane, which is not the same: rounding "
                     "decides at each point which is seen; move one of them.");
    }
  }

  void check_bounds(const Instance& instance, const Box& box) const {
    if (!(max_abs(box.min) <= kMaxCoordinate && max_abs(box.max) <= kMaxCoordinate)) {
      document_.fail(*instance.element, "coordinates reach beyond 1e30; scale the scene down");
    }
  }

  void add_sphere(const Instance& instance, double radius) {
    const std::optional<Sphere> sphere = place_sphere(radius, instance.to_world);
    if (!sphere) {
      document_.fail(*instance.node, "sphere " + label(*instance.node) +
                                         " is scaled unevenly, sheared or to nothing; make its "
                                         "scale uniform, or make it a mesh");
    }
    check_bounds(instance, bounds(*sphere));
    const int material = material_index(instance, "");
    scene_.primitives.spheres.push_back(*sphere);
    material_of_spheres_.push_back(material);
    const Rgb emission = scene_.materials[material].emission;
    const std::size_t index = scene_.primitives.spheres.size() - 1;
    if (!is_black(emission)) lamps_.push_back({&instance, true, index, index + 1, emission});
  }

  void add_part(const Instance& instance, const MeshPart& part) {
    std::vector<Triangle>& all = scene_.primitives.triangles;
    const std::size_t before = all.size();
    Box box;
    for (std::size_t i = 0; i < part.size(); ++i) {
      const FileTriangle triangle = part.triangle(i);
      for (const Vec3 p : triangle.p) box.grow(instance.to_world.point(p));
      if (const std::optional<Triangle> t = place(triangle, instance.to_world)) all.push_back(*t);
    }
    check_bounds(instance, box);
    const std::span<const Triangle> placed(all.begin() + static_cast<std::ptrdiff_t>(before),
                                           all.end());
    without_area_ += part.size() - placed.size();
    if (placed.empty()) return;
    const int material = material_index(instance, part.material_symbol);
    scene_.material_of.resize(all.size(), material);
    const Rgb emission = scene_.materials[material].emission;
    if (!is_black(emission)) {
      check_winding(placed, label(*instance.node));
      lamps_.push_back({&instance, false, before, all.size(), emission});
    }
  }

  void add_emitter(const Instance& instance, const Emitter& emitter) {
    found_.emitters.push_back(emitter);
    if (found_.emitters.size() > kMaxLights) {
      document_.fail(*instance.element,
                     "the scene has more than 10,000 emitting surfaces; use fewer");
    }
  }

  void check_winding(std::span<const Triangle> triangles, const std::string& name) {
    double agreement = 0;
    for (const Triangle& t : triangles) agreement += dot(geometric_normal(t), t.n0 + t.n1 + t.n2);
    if (agreement < 0) {
      document_.note("emitting surface " + name +
                     " has normals against its winding order: it emits on the side of the "
                     "winding order.");
    }
  }

  const XMLElement* find_binding(const Instance& instance, const std::string& symbol) {
    const auto [known, is_new] = bindings_.try_emplace(instance.element);
    Bindings& bindings = known->second;
    if (is_new) bindings = read_bindings(*instance.element);
    const auto found = bindings.by_symbol.find(symbol);
    return found == bindings.by_symbol.end() ? bindings.only : found->second;
  }

  int material_index(const Instance& instance, const std::string& symbol) {
    const XMLElement* binding = find_binding(instance, symbol);
    if (binding == nullptr && without_material_++ == 0) {
      first_without_material_ = label(*instance.node);
    }
    const XMLElement* element = binding ? find_material(*binding) : nullptr;
    const auto next = static_cast<int>(scene_.materials.size());
    const auto [material, is_new] = materials_.emplace(element, next);
    if (is_new) add_material(element);
    return material->second;
  }

  const XMLElement* find_material(const XMLElement& binding) {
    const auto found = document_.find_or_note(binding, "target", "material", "the albedo is 0.5");
    return found.first ? &document_.resolve(binding, "target", "material") : nullptr;
  }

  void add_material(const XMLElement* element) {
    FileMaterial read;
    read.material.name = "default";
    if (element) read = read_material(document_, *element, options_);
    found_.ignores_emission = found_.ignores_emission || read.ignores_emission;
    scene_.materials.push_back(read.material);
  }

  const Document& document_;
  const LoadOptions& options_;
  Surfaces found_;
  Scene& scene_ = found_.scene;
  std::vector<int> material_of_spheres_;
  std::vector<Lamp> lamps_;
  std::size_t placed_ = 0;
  std::size_t copies_ = 0;
  std::size_t without_area_ = 0;
  std::size_t without_material_ = 0;
  std::string first_without_material_;
  std::unordered_map<const XMLElement*, Geometry> geometries_;
  std::unordered_map<const XMLElement*, int> materials_;
  std::unordered_map<const XMLElement*, Bindings> bindings_;
};

}  // namespace

Surfaces read_surfaces(const Document& document, const std::vector<Instance>& geometries,
                       const LoadOptions& options) {
  SurfaceReader reader(document, options);
  for (const Instance& instance : geometries) reader.read(instance);
  reader.place_all(geometries);
  return reader.take();
}

}  // namespace pt
