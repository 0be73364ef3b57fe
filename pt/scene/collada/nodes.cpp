#include "pt/scene/collada/nodes.h"

#include "pt/scene/collada/transforms.h"

#include <algorithm>
#include <optional>
#include <unordered_map>
#include <utility>

#include <tinyxml2.h>

namespace pt {

namespace {

// Instances of instances may double with every step, so that a short file can have any number.
constexpr std::size_t kMaxNodes = 100'000;
constexpr std::size_t kMaxInstances = 100'000;
constexpr std::size_t kMaxDepth = 200;
constexpr int kMaxControllers = 10;  // a skin of a morph of ...

// A child of a node that puts something into the scene: a node, or an instance of `target`.
struct Child {
  std::string_view kind;  // of the target: node, geometry, light or camera
  const XMLElement* element;
  const XMLElement* target;
  std::optional<Transform> before{};  // the node's own, applied to the target first
};

// The content of a node. It is read once, however often the node is instanced.
struct NodeContent {
  Transform to_parent;
  std::vector<Child> children;
};

class NodeWalk {
 public:
  explicit NodeWalk(const Document& document) : document_(document) {}

  void visit(const XMLElement& node, const Transform& parent) {
    enter(node);
    const NodeContent& content = read(node);
    const Transform to_world = parent * content.to_parent;
    check_finite(document_, node, to_world);
    for (const Child& child : content.children) {
      if (child.kind == "node") {
        visit(*child.target, to_world);
      } else {
        place(child, node, to_world);
      }
    }
    path_.pop_back();
  }

  Instances take() { return std::move(found_); }

 private:
  void enter(const XMLElement& node) {
    if (std::find(path_.begin(), path_.end(), &node) != path_.end()) {
      document_.fail(node, "node " + label(node) + " contains itself; remove one <instance_node>");
    }
    if (path_.size() > kMaxDepth) {
      document_.fail(node, "nodes are nested more than 200 deep; flatten the scene");
    }
    if (++visited_ > kMaxNodes) {
      document_.fail(
          node,
          "the scene has more than 100,000 nodes when each <instance_node> is a copy; use fewer");
    }
    path_.push_back(&node);
  }

  const NodeContent& read(const XMLElement& node) {
    const auto known = contents_.find(&node);
    if (known != contents_.end()) return known->second;
    NodeContent content;
    content.to_parent = node_transform(document_, node);
    for (const XMLElement* child : children(node)) {
      if (const std::optional<Child> kept = read_child(*child)) content.children.push_back(*kept);
    }
    return contents_.emplace(&node, std::move(content)).first->second;
  }

  std::optional<Child> read_child(const XMLElement& child) {
    const std::string_view name = child.Name();
    if (name == "node") return Child{"node", &child, &child};
    if (name == "instance_controller") return mesh_as_bound(child);
    for (const char* kind : {"node", "geometry", "light", "camera"}) {
      if (name == std::string("instance_") + kind) return named_child(kind, child, "url");
    }
    return std::nullopt;
  }

  // The mesh of an <instance_controller>, below any number of skins and morphs, as it was when its
  // skeleton was bound to it. Joints, weights and targets are ignored.
  std::optional<Child> mesh_as_bound(const XMLElement& instance) {
    const XMLElement* from = &instance;
    const char* key = "url";
    Transform shape;
    for (int depth = 0; depth < kMaxControllers; ++depth) {
      if (document_.find(from, key, "controller").first == nullptr) {
        const bool is_mesh = depth > 0 || document_.find(from, key, "geometry").first != nullptr;
        const auto mesh = named_child(is_mesh ? "geometry" : "controller", *from, key);
        if (!mesh) return std::nullopt;
        document_.note("animated mesh " + label(*mesh->target) +
                       " is shown as it was bound: its joints and targets are ignored.");
        return Child{mesh->kind, &instance, mesh->target, shape};
      }
      const XMLElement& controller = document_.resolve(*from, key, "controller");
      const XMLElement* skin = controller.FirstChildElement("skin");
      const XMLElement* matrix = find_below(skin, {"bind_shape_matrix"});
      if (matrix) shape = shape * read_matrix(document_, *matrix, false);
      from = skin ? skin : &document_.child(controller, "morph");
      key = "source";
    }
    document_.fail(instance,
                   "its controllers refer to each other, or are more than 10; remove some");
  }

  // Exporters write instances of things that are missing. The rest of the scene can still be shown;
  // and if several lights or cameras have the same id, the scene can be shown with the first.
  std::optional<Child> named_child(const char* kind, const XMLElement& child, const char* key) {
    const Document::Identified target =
        document_.find_or_note(child, key, kind, "the instance is left out");
    if (target.first == nullptr) return std::nullopt;
    const Child found{kind, &child, target.first};
    if (target.second == nullptr) return found;
    if (found.kind != "light" && found.kind != "camera") document_.resolve(child, key, kind);
    document_.note(Document::ambiguity(attribute(&child, key), target) + ": the first is taken.");
    return found;
  }

  void place(const Child& child, const XMLElement& node, const Transform& to_world) {
    if (++placed_ > kMaxInstances) {
      document_.fail(*child.element,
                     "the scene has more than 100,000 instances when each <instance_node> is a "
                     "copy; use fewer");
    }
    std::vector<Instance>& instances = child.kind == "geometry" ? found_.geometries
                                       : child.kind == "light"  ? found_.lights
                                                                : found_.cameras;
    const Transform map = child.before ? to_world * *child.before : to_world;
    check_finite(document_, node, map);
    instances.push_back({child.element, child.target, &node, map});
  }

  const Document& document_;
  Instances found_;
  std::vector<const XMLElement*> path_;
  std::unordered_map<const XMLElement*, NodeContent> contents_;
  std::size_t visited_ = 0;
  std::size_t placed_ = 0;
};

// World space is right-handed with y up; each map is a rotation.
struct UpAxis {
  Transform to_world;
  Vec3 front{0, 0, 1};  // the world's direction towards the viewer (COLLADA 1.4.1, "up_axis")
};

UpAxis up_axis(const Document& document) {
  const XMLElement* element = find_below(&document.root(), {"asset", "up_axis"});
  const std::string_view axis = trimmed_text(element);
  if (axis == "Y_UP" || axis.empty()) return {};
  if (axis == "Z_UP") return {{{-1, 0, 0}, {0, 0, 1}, {0, 1, 0}, {}}, {0, 0, -1}};
  if (axis == "X_UP") return {{{0, 1, 0}, {1, 0, 0}, {0, 0, -1}, {}}, {0, 0, -1}};
  document.fail(*element, "up_axis is " + quoted(axis) + "; write X_UP, Y_UP or Z_UP");
}

const XMLElement& find_visual_scene(const Document& document) {
  const XMLElement* instance = find_below(&document.root(), {"scene", "instance_visual_scene"});
  if (document.find(instance, "url", "visual_scene").first) {
    return document.resolve(*instance, "url", "visual_scene");
  }
  std::vector<const XMLElement*> all;
  for (const XMLElement* library : children(document.root(), "library_visual_scenes")) {
    for (const XMLElement* scene : children(*library, "visual_scene")) all.push_back(scene);
  }
  if (all.size() != 1) {
    document.fail(instance ? *instance : document.root(),
                  "the file has no <scene> that names one of its " + std::to_string(all.size()) +
                      " <visual_scene>s; add one");
  }
  document.note("no <scene> names what is shown: it is the only <visual_scene> of the file.");
  return *all[0];
}

}  // namespace

Instances read_nodes(const Document& document) {
  const XMLElement& visual_scene = find_visual_scene(document);
  const UpAxis up = up_axis(document);
  NodeWalk walk(document);
  // A visual scene is read as a node: some exporters put instances straight into it.
  walk.visit(visual_scene, up.to_world);
  Instances instances = walk.take();
  instances.front = up.front;
  return instances;
}

}  // namespace pt
