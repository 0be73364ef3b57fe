#include "pt/scene/collada/nodes.h"

#include "pt/scene/collada/numbers.h"
#include "pt/scene/collada/transforms.h"

#include <algorithm>
#include <cstring>

#include <tinyxml2.h>

namespace pt {

namespace {

// Instances of instances may double with every step, so that a short file can ask for any number.
constexpr std::size_t kMaxNodes = 100'000;
constexpr std::size_t kMaxDepth = 200;

class NodeWalk {
 public:
  explicit NodeWalk(const ColladaDocument& document) : document_(document) {}

  void visit(const XMLElement& node, const Transform& parent) {
    enter(node);
    const Transform to_world = parent * node_transform(document_, node, found_.notes);
    check_finite(document_, node, to_world);
    for (const XMLElement* child = node.FirstChildElement(); child != nullptr;
         child = child->NextSiblingElement()) {
      visit_child(*child, node, to_world);
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
      document_.fail(node, "the scene unfolds to more than 100,000 nodes; instance fewer");
    }
    path_.push_back(&node);
  }

  void visit_child(const XMLElement& child, const XMLElement& node, const Transform& to_world) {
    const std::string_view kind = child.Name();
    if (kind == "node") {
      visit(child, to_world);
    } else if (kind == "instance_node") {
      visit(document_.resolve(child, "url", "node"), to_world);
    } else if (kind == "instance_geometry") {
      found_.geometries.push_back({&child, &node, to_world});
    } else if (kind == "instance_light") {
      found_.lights.push_back({&child, &node, to_world});
    } else if (kind == "instance_camera") {
      found_.cameras.push_back({&child, &node, to_world});
    } else if (kind == "instance_controller") {
      document_.fail(child,
                     "an animated mesh (<instance_controller>) cannot be read; apply its "
                     "modifiers and export it as a mesh");
    }
  }

  const ColladaDocument& document_;
  Instances found_;
  std::vector<const XMLElement*> path_;
  std::size_t visited_ = 0;
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
