#pragma once

#include "pt/image/film.h"
#include "pt/render/options.h"

#include <string>

// The files that the render program writes, and the picture that it goes on with.

namespace pt {

// Throws Error unless all pictures of these options can be written, and fit the memory together with
// what is needed to write them. Call it before the work.
void check_targets(const RenderOptions& options);

// The picture of --resume; empty without it. Throws Error if it was not made with these options. The
// number of samples may be another.
Film picture_to_go_on_with(const RenderOptions& options);

void write_pictures(const RenderOptions& options, const Film& film);

// The reason why the picture has fewer samples than were asked for, and how to get them.
std::string note_on_missing_samples(const RenderOptions& options, const Film& film,
                                    bool is_interrupted);

}  // namespace pt
