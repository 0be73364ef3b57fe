#include "writeup/accuracy/begin.h"

#include "pt/error.h"
#include "pt/todo_list.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace writeup::accuracy {

Measuring::Measuring(const Options& options, int bounces, double share)
    : loaded(load_scene(options)),
      view{loaded.scene,
           frame_camera(loaded, options.framing, options.width, options.height),
           {},
           options.width,
           options.height},
      study(
          view, options.threads, options.seed, {share * options.seconds, 0},
          [this, share](double part) { progress.show(share * part); }, bounces) {
  print_notes(loaded);
  const std::vector<std::string> unwritten = pt::todo_list();
  if (unwritten.empty()) return;
  progress.clear();
  throw pt::Error(fmt::format("not written yet: {}; nothing can be measured without",
                              fmt::join(unwritten, ", ")));
}

}  // namespace writeup::accuracy
