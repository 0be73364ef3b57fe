#include "writeup/accuracy/rung_wire.h"

#include "pt/error.h"
#include "pt/render/option_words.h"

#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace writeup::accuracy {

namespace {

using Direct = pt::PathSettings::Direct;

std::string word(pt::Framing framing) {
  for (const auto& [text, value] : pt::kFramingWords) {
    if (value == framing) return text;
  }
  return "";
}

void require(const std::istringstream& line, const char* what) {
  if (line.fail()) throw pt::Error(fmt::format("a program of the ladder got no {}", what));
}

}  // namespace

std::string to_line(const RungRequest& request) {
  const pt::PathSettings& path = request.path;
  const pt::RenderSettings& render = request.render;
  // A batch of 0: not adaptive.
  const pt::AdaptiveSettings adaptive = render.adaptive.value_or(pt::AdaptiveSettings{0, 0, 0});
  return fmt::format("{} {} {} {} {} {} {} {} {} {} {} {} {}",
                     path.direct == Direct::hemisphere ? 1 : 0, path.light_samples, path.survival,
                     path.from, path.to, render.samples, render.seed, render.threads,
                     adaptive.max_samples, adaptive.batch, adaptive.tolerance, request.first,
                     request.step);
}

RungRequest request_from(const std::string& text) {
  std::istringstream line(text);
  RungRequest request;
  pt::AdaptiveSettings adaptive;
  int hemisphere = 0;
  line >> hemisphere >> request.path.light_samples >> request.path.survival >> request.path.from >>
      request.path.to >> request.render.samples >> request.render.seed >> request.render.threads >>
      adaptive.max_samples >> adaptive.batch >> adaptive.tolerance >> request.first >> request.step;
  require(line, "request");
  request.path.direct = hemisphere != 0 ? Direct::hemisphere : Direct::lights;
  if (adaptive.batch > 0) request.render.adaptive = adaptive;
  return request;
}

std::string to_line(const RungReply& reply) {
  return fmt::format("{} {} {} {} {}", reply.cpu_seconds, reply.rays, reply.samples,
                     reply.mean.size(), fmt::join(reply.mean, " "));
}

RungReply reply_from(const std::string& text) {
  std::istringstream line(text);
  RungReply reply;
  std::size_t pixels = 0;
  line >> reply.cpu_seconds >> reply.rays >> reply.samples >> pixels;
  require(line, "reply");
  reply.mean.resize(pixels);
  for (double& mean : reply.mean) line >> mean;
  require(line, "pixels");
  return reply;
}

std::vector<std::string> words_of(const Options& options) {
  std::vector<std::string> words{options.scene.string(),
                                 "-r",
                                 std::to_string(options.width),
                                 std::to_string(options.height),
                                 "--camera",
                                 word(options.framing),
                                 "--engine",
                                 std::string(name(options.engine)),
                                 "--seed",
                                 std::to_string(options.seed)};
  if (options.lambertian) words.emplace_back("--lambertian");
  return words;
}

}  // namespace writeup::accuracy
