#pragma once

#include "pt/scene/frame_camera.h"
#include "pt/scene/tracer.h"

#include <map>
#include <string>

namespace pt {

// The words after --engine and --camera, in every program that has them.
inline const std::map<std::string, Engine> kEngineWords{
    {"linear", Engine::linear}, {"task", Engine::task}, {"wide", Engine::wide}};
inline const std::map<std::string, Framing> kFramingWords{
    {"course", Framing::course}, {"fit", Framing::fit}, {"file", Framing::file}};

}  // namespace pt
