#include "pt/scene/collada/nodes.h"

#include "pt/scene/collada/numbers.h"
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

// A child of a node that puts something into the scene: a node, or an instance of `target`.
struct Child {
  enum class Kind { node, geometry, light, camera } kind;
  const XMLElement* element;
  const XMLElement* target;
};

// The content of a node. It is read once, however often the node is instanced.
struct NodeContent {
  Transform to_parent;
  std::vector<Child> children;
};

class NodeWalk {
 public:
  explicit NodeWalk(const ColladaDocument& document) : document_(document) {}

  void visit(const XMLElement& node, const Transform& parent) {
    enter(node);
    const NodeContent& content = read(node);
    const Transform to_world = parent * content.to_parent;
    check_finite(document_, node, to_world);
    for (const Child& child : content.children) {
      if (child.kind == Child::Kind::node) {
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
    if (path_.size() >= kMaxDepth) {
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
    content.to_parent = node_transform(document_, node, found_.notes);
    for (const XMLElement* child = node.FirstChildElement(); child != nullptr;
         child = child->NextSiblingElement()) {
      if (const std::optional<Child> kept = read_child(*child)) content.children.push_back(*kept);
    }
    return contents_.emplace(&node, std::move(content)).first->second;
  }

  std::optional<Child> read_child(const XMLElement& child) {
    using Kind = Child::Kind;
    const std::string_view kind = child.Name();
    if (kind == "node") return Child{Kind::node, &child, &child};
    if (kind == "instance_node") {
      return Child{Kind::node, &child, &document_.resolve(child, "url", "node")};
    }
    if (kind == "instance_geometry") {
      return Child{Kind::geometry, &child, &document_.resolve(child, "url", "geometry")};
    }
    if (kind == "instance_light") return optional_child(Kind::light, child, "light");
    if (kind == "instance_camera") return optional_child(Kind::camera, child, "camera");
    if (kind == "instance_controller") {
      document_.fail(child,
                     "an animated mesh (<instance_controller>) cannot be read; apply its "
                     "modifiers and export it as a mesh");
    }
    return std::nullopt;
  }

  // Exporters write instances of missing lights and cameras, and several with the same id. The scene can still
  // be shown.
  std::optional<Child> optional_child(Child::Kind kind, const XMLElement& child, const char* name) {
    const std::string_view url = document_.attribute(child, "url");
    const ColladaDocument::Identified target = document_.find(child, url, name);
    if (target.second != nullptr) {
      found_.notes.push_back(ColladaDocument::ambiguity(url, target) + ": the first is taken.");
    }
    if (target.first != nullptr) return Child{kind, &child, target.first};
    found_.notes.push_back(std::string("there is no <") + name + "> with the id that " +
                           quoted(url) + " names: the instance is left out.");
    return std::nullopt;
  }

  void place(const Child& child, const XMLElement& node, const Transform& to_world) {
    if (++placed_ > kMaxInstances) {
      document_.fail(*child.element,
                     "the scene has more than 100,000 instances when each <instance_node> is a "
                     "copy; use fewer");
    }
    std::vector<Instance>& instances = child.kind == Child::Kind::geometry ? found_.geometries
                                       : child.kind == Child::Kind::light  ? found_.lights
                                                                           : found_.cameras;
    instances.push_back({child.element, child.target, &node, to_world});
  }

  const ColladaDocument& document_;
  Instances found_;
  std::vector<const XMLElement*> path_;
  std::unordered_map<const XMLElement*, NodeContent> contents_;
  std::size_t visited_ = 0;
  std::size_t placed_ = 0;
};

// World space is right-handed with y up; each map is a rotation.
Transform up_axis(const ColladaDocument& document) {
  const XMLElement* asset = document.root().FirstChildElement("asset");
  const XMLElement* element = asset ? asset->FirstChildElement("up_axis") : nullptr;
  if (element == nullptr) return {};
  const char* text = element->GetText();
  const std::string_view axis = text ? text : "";
  if (axis == "Y_UP") return {};
  if (axis == "Z_UP") return {{-1, 0, 0}, {0, 0, 1}, {0, 1, 0}, {}};
  if (axis == "X_UP") return {{0, 1, 0}, {1, 0, 0}, {0, 0, -1}, {}};
  document.fail(*element, "up_axis is " + quoted(axis) + "; write X_UP, Y_UP or Z_UP");
}

}  // namespace

Instances read_nodes(const ColladaDocument& document) {
  const XMLElement& scene = document.child(document.root(), "scene");
  const XMLElement& visual_scene =
      document.resolve(document.child(scene, "instance_visual_scene"), "url", "visual_scene");
  const Transform up = up_axis(document);
  NodeWalk walk(document);
  for (const XMLElement* node = visual_scene.FirstChildElement("node"); node != nullptr;
       node = node->NextSiblingElement("node")) {
    walk.visit(*node, up);
  }
  return walk.take();
}

}  // namespace pt
