#pragma once

#include "pt/scene/load_collada.h"
#include "pt/scene/view.h"

#include <filesystem>
#include <string>

namespace pt {

// "the scene has no light", and why if the file has an emission colour that is ignored; empty if the
// scene has one.
std::string no_light(const LoadedScene& loaded);

// Throws Error with that sentence, or that of require_supported. Call it before you measure light.
void require_light(const LoadedScene& loaded, const std::filesystem::path& file);

// Says why nothing can be seen in a picture at that exposure, and what to do; empty if something
// can. `brightest` is its largest channel. The scene has a light. Of a black picture it first names
// the tasks that are stubs; other reasons are looked for by rays that call no task.
std::string note_on_darkness(const View& view, double brightest, double exposure);

}  // namespace pt
