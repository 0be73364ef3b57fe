#include "pt/scene/collada/controllers.h"

#include "pt/scene/collada/transforms.h"

#include <string_view>

#include <tinyxml2.h>

namespace pt {

namespace {

constexpr int kMaxControllers = 10;  // a skin of a morph of ...

}  // namespace

std::optional<BindPose> bind_pose(const ColladaDocument& document, const XMLElement& instance,
                                  std::vector<std::string>& notes) {
  const XMLElement* from = &instance;
  const char* attribute = "url";
  BindPose pose{};
  for (int depth = 0; depth < kMaxControllers; ++depth) {
    const std::string_view url = document.attribute(*from, attribute);
    if (document.find(*from, url, "geometry").first != nullptr) {
      pose.geometry = &document.resolve(*from, attribute, "geometry");
      notes.push_back("animated mesh " + label(*pose.geometry) +
                      " is shown as it was bound: its joints and targets are ignored.");
      return pose;
    }
    if (document.find(*from, url, "controller").first == nullptr) {
      notes.push_back(document.missing(url, depth == 0 ? "controller" : "geometry") +
                      ": the instance is left out.");
      return std::nullopt;
    }
    const XMLElement& controller = document.resolve(*from, attribute, "controller");
    const XMLElement* skin = controller.FirstChildElement("skin");
    const XMLElement* matrix = skin ? skin->FirstChildElement("bind_shape_matrix") : nullptr;
    if (matrix) pose.shape = pose.shape * read_matrix(document, *matrix, false, notes);
    from = skin ? skin : &document.child(controller, "morph");
    attribute = "source";
  }
  document.fail(instance, "its controllers refer to each other, or are more than 10; remove some");
}

}  // namespace pt
