#pragma once

#include <string_view>

namespace scenes {

// A scene without surfaces, seen a little from above.
inline constexpr std::string_view kOpenScene =
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

}  // namespace scenes
