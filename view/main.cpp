// ./run view: serves the page on which a person sees the light of a scene, or writes it as one file.
#include "grader/report/embedded.h"
#include "pt/end_of_program.h"
#include "pt/file.h"
#include "pt/image/tone_map.h"
#include "view/options.h"
#include "view/page.h"
#include "view/server.h"

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdlib>
#include <future>
#include <optional>

#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <unistd.h>

// macOS has it in no header.
extern char** environ;  // NOLINT(readability-redundant-declaration)

namespace view {
namespace {

using nlohmann::json;

std::atomic<bool> interrupted = false;                  // set by Ctrl-C
static_assert(std::atomic<bool>::is_always_lock_free);  // or a signal handler could not set it

Program program_of(const std::filesystem::path& worker, const Options& options) {
  const std::string scene = std::filesystem::absolute(options.scene).string();
  Program program{{worker.string(), scene}, {}, scene};
  if (options.lambertian) program.command.emplace_back("--lambertian");
  return program;
}

// The program with a submission's tasks. Says which of them do not compile; the reference replaces these.
Program boxed_program(const Options& options) {
  constexpr std::size_t kMaxFile = 1 << 20;
  const json boxed = json::parse(pt::read_file(options.boxed, kMaxFile));
  for (const auto& [task, why] : boxed.at("unusable").items()) {
    fmt::print(stderr, "{} of the reference is shown: {}\n", task,
               pt::printable(why.get<std::string>(), true));
  }
  Program program = program_of(boxed.at("worker").get<std::string>(), options);
  program.box = grader::sandbox::tier_of(boxed.at("tier").get<std::string>());
  program.command.emplace_back("--one-thread");
  return program;
}

json page_data(const Options& options, bool live) {
  json data{{"live", live},
            {"from", options.from},
            {"boxed", !options.boxed.empty()},
            {"scene_file", options.scene.string()},
            {"reference", !options.reference.empty()},
            {"settings", options.settings}};
  if (options.pixel) data["pixel"] = {options.pixel->first, options.pixel->second};
  return data;
}

void say(const std::string& note) {
  if (!note.empty()) fmt::print(stderr, "{}\n", note);
}

// Asks for a picture, or a disk, until `counted` of its state is so much. No time ends it: the same page has the same bytes.
Reply settled(Child& child, const std::string& what,
              const std::map<std::string, std::string>& question, const char* counted, int most) {
  for (;;) {
    Reply reply = child.ask(what, question);
    if (reply.state.at(counted) < most && reply.state.at("goes_on")) continue;
    reply.state.erase("seconds");
    return reply;
  }
}

Reply settled_picture(Child& child, const std::map<std::string, std::string>& settings) {
  return settled(child, "picture", settings, "samples", 30);
}

Reply settled_disk(Child& child, const std::map<std::string, std::string>& question) {
  return settled(child, "disk", question, "passes", 8);
}

json as_text(const Reply& reply) {
  json text = reply.state;
  text["base64"] = grader::report::base64(reply.bytes);
  return text;
}

// The directions above a point, for the page: the point that it shows first. `of` are the words of the question about the pixel.
json disk_of(const json& paths, std::map<std::string, std::string> of, Child& own,
             Child* reference) {
  const json& all = paths.at("paths");
  const auto is_red = [](const json& path) { return !path.at("findings").empty(); };
  auto path = std::ranges::find_if(all, is_red);
  const int point =
      path == all.end() ? 0 : std::max(path->at("findings")[0].at("bounce").get<int>() - 1, 0);
  if (path == all.end()) path = all.begin();
  if (path == all.end() || point >= static_cast<int>(path->at("bounces").size())) return {};
  std::string met;
  for (const json& number : path->at("bounces")[point].at("met")) {
    if (!number.is_number()) return {};  // "nan"
    met += (met.empty() ? "" : ",") + number.dump();
  }
  for (const char* word : {"adaptive", "show", "bounce", "eye", "target", "up"}) of.erase(word);
  of["met"] = met;
  of["point"] = std::to_string(point);
  json disk{{"path", path - all.begin()}, {"point", point}};
  disk["own"] = as_text(settled_disk(own, of));
  if (reference != nullptr) disk["reference"] = as_text(settled_disk(*reference, of));
  return disk;
}

void write_page(const Options& options, Child& own, Child* reference) {
  pt::check_target(options.page);
  std::map<std::string, std::string> of_picture = options.settings, of_pixel = options.settings;
  of_picture.erase("samples");
  of_pixel.erase("shown");
  const auto [x, y] =
      options.pixel.value_or(std::pair(std::stoi(of_pixel["w"]) / 2, std::stoi(of_pixel["h"]) / 2));
  of_pixel["x"] = std::to_string(x);
  of_pixel["y"] = std::to_string(y);
  json data = page_data(options, false);
  data["pixel"] = {x, y};
  data["paths"] = own.ask("paths", of_pixel).state;
  if (reference != nullptr) data["reference_paths"] = reference->ask("paths", of_pixel).state;
  data["scene"] = own.ask("scene", of_picture).state;
  const json disk = disk_of(data["paths"], of_pixel, own, reference);
  if (!disk.is_null()) data["disk"] = disk;
  of_pixel.erase("samples");
  data["ray"] = own.ask("ray", of_pixel).state;
  data["depth"] = as_text(own.ask("depth", of_picture));
  const Reply picture = settled_picture(own, of_picture);
  say(picture.state.at("note"));
  if (of_picture.contains("shown")) {
    data["numbers"] = as_text(picture);
  } else {
    data["picture"] = grader::report::png_address(tone_map(mean(film_of(picture))));
  }
  pt::write_file(options.page, options.page.extension() == ".json"
                                   ? data.dump(-1, ' ', true, json::error_handler_t::replace)
                                   : page_with(data));
  fmt::print("wrote {}\n", pt::printable(options.page.string()));
}

// Opens the address where there is a screen. A Mac always has one.
void open_browser(const std::string& address) {
#ifdef __APPLE__
  std::string program = "open";
#else
  if (std::getenv("DISPLAY") == nullptr && std::getenv("WAYLAND_DISPLAY") == nullptr) return;
  std::string program = "xdg-open";
#endif
  std::string word = address;
  std::array<char*, 3> command{program.data(), word.data(), nullptr};
  pid_t pid = 0;
  posix_spawnp(&pid, program.c_str(), nullptr, nullptr, command.data(), environ);
}

// Waits for q on a terminal, or Ctrl-C.
void wait_for_end() {
  bool listens = isatty(STDIN_FILENO) != 0;
  while (!interrupted) {
    pollfd input{listens ? STDIN_FILENO : -1, POLLIN, 0};
    if (poll(&input, 1, 200) <= 0 || input.revents == 0) continue;
    char key = 0;
    if (read(STDIN_FILENO, &key, 1) <= 0) listens = false;
    if (key == 'q') return;
  }
}

void serve(const Options& options, Child& own, Child* reference) {
  const std::string token = random_token();
  json data = page_data(options, true);
  data["token"] = token;
  data["watched"] = !options.tasks.empty();
  std::optional<Live> live;
  if (!options.tasks.empty()) {
    std::vector<std::string> command = {"/usr/bin/env", "bash"};
    command.insert(command.end(), options.build.begin(), options.build.end());
    command.push_back(options.worker.filename().string());
    live.emplace(options.tasks, command, own);
  }
  Server server({page_with(data), token, &own, reference, live ? &*live : nullptr});
  server.bind(options.port);
  std::signal(SIGINT, [](int) { interrupted = true; });
  std::signal(SIGTERM, [](int) { interrupted = true; });
  const auto listening = std::async(std::launch::async, [&] { server.listen(); });
  fmt::print("{}\n(q and Enter, or Ctrl-C, ends it)\n", server.address());
  std::fflush(stdout);
  if (!options.no_browser) open_browser(server.address());
  wait_for_end();
  server.stop();
  own.stop();
  if (reference != nullptr) reference->stop();
}

int run(int argc, const char* const* argv) {
  const Options options = parse_options(argc, argv);
  Child own(options.boxed.empty() ? program_of(options.worker, options) : boxed_program(options));
  std::optional<Child> reference;
  if (!options.reference.empty()) reference.emplace(program_of(options.reference, options));
  Child* const beside = reference ? &*reference : nullptr;
  std::signal(SIGPIPE, SIG_IGN);
  std::map<std::string, std::string> settings = options.settings;
  if (options.pixel) {
    settings["x"] = std::to_string(options.pixel->first);
    settings["y"] = std::to_string(options.pixel->second);
  }
  // A scene that cannot be read, or a pixel outside, ends it here.
  const Reply scene = (options.boxed.empty() ? own : *reference).ask("scene", settings);
  for (const json& note : scene.state.at("notes")) say(note);
  if (options.page.empty()) {
    serve(options, own, beside);
  } else {
    write_page(options, own, beside);
  }
  return 0;
}

}  // namespace
}  // namespace view

int main(int argc, char** argv) {
  return pt::run_program([&] { return view::run(argc, argv); });
}
