#include "grader/service/build/builder.h"

#include "grader/base/printable.h"
#include "grader/base/sha256.h"
#include "grader/service/audit/audit.h"
#include "grader/service/audit/object_file.h"
#include "grader/service/build/cache.h"
#include "grader/service/build/compiler_output.h"
#include "grader/service/build/submission_flags.h"
#include "grader/service/build/tool_run.h"
#include "grader/tasks.h"
#include "pt/error.h"
#include "pt/file.h"

#include <filesystem>
#include <set>

#include <fmt/format.h>

namespace grader::build {

namespace {

namespace fs = std::filesystem;

// Far more than the size of a worker.
constexpr std::size_t kMaxWorker = std::size_t{64} << 20;

// A submission can make a compiler run for ever or fill the disk.
constexpr process::Limits kCompilerLimits{
    .cpu_seconds = {},
    .address_space = kToolMemory,
    .file_size = kMaxWorker,
    .processes = 64,
    .open_files = 256,
};

// Far more than the object of any task.
constexpr std::size_t kMaxObject = std::size_t{16} << 20;

std::string name_of_part(const std::string& object) { return base::sha256(object) + ".o"; }

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

void add(sandbox::Box& box, const std::vector<std::string>& words) {
  box.command.insert(box.command.end(), words.begin(), words.end());
}

void keep_worker(const ToolFolder& place, const std::string& path) {
  const base::Submitted worker = place.take("worker", kMaxWorker);
  if (!worker.present || !worker.rejected.empty()) {
    throw pt::Error("the linked worker is not there: " + worker.rejected);
  }
  const std::string temporary = pt::temporary_name(path);
  keep(temporary, worker.text);
  // Another user runs the program.
  fs::permissions(temporary, fs::perms(0755));
  fs::rename(temporary, path);
}

// The functions that the reference of the task defines.
std::set<std::string> contract_of(const TaskConfig& task) {
  std::set<std::string> functions;
  for (const std::string& object : task.reference) {
    functions.merge(audit::functions_in(pt::read_file(object)));
  }
  return functions;
}

// The functions that pt/examples/ defines, besides inline ones, and the one that makes a light.
constexpr const char* kForExamples[] = {
    "make_mesh_light",
    "examples::add",
    "examples::expect",
    "examples::near",
    "scenes::with_rectangle",
    "scenes::with_screen",
    "scenes::with_lamp",
    "scenes::floor_under",
    "scenes::floor_under_sky",
    "scenes::floor_under_lamp",
    "scenes::floor_under_ball",
    "scenes::furnace",
    "scenes::ball_with_point_light",
    "scenes::seen",
    "scenes::middle_of_floor",
    "scenes::share_of_sky",
    "scenes::bright",
    "scenes::view_of",
};

// Examples of a task may call it and all other tasks, what pt/examples/ declares, and all that any task may call of the renderer.
Task rules_of_examples(Task task) {
  std::set<std::string> names(task.framework.begin(), task.framework.end());
  for (const Task& each : tasks()) {
    names.insert(each.framework.begin(), each.framework.end());
    for (const std::string& function : each.functions) names.insert("pt::" + function);
    names.insert("pt::" + each.slug);  // stands for its header
  }
  // These stand for the headers example.h, inputs.h and scenes.h.
  names.insert({"pt::example", "pt::inputs", "pt::scenes"});
  for (const char* name : kForExamples) names.insert(std::string("pt::") + name);
  task.framework.assign(names.begin(), names.end());
  return task;
}

}  // namespace

Builder::Builder(const Config& config, sandbox::Tier tier, int seconds)
    : config_(config),
      tier_(tier),
      seconds_(seconds),
      cache_(config.work + "/cache"),
      running_(cache_),
      headers_(public_headers(config.root)),
      precompiled_(config, headers_) {
  // Objects from a weaker tier, or from another judge's audit, are not used.
  std::string tools = base::stamp(config.compiler) +
                      content_stamp(fs::read_symlink("/proc/self/exe"), cache_) +
                      sandbox::letter(tier);
  for (const char* flag : kSubmissionFlags) tools += std::string(flag) + '\0';
  for (const auto* flags : {&config.compile_flags, &config.link_flags, &config.recording_flags}) {
    for (const std::string& flag : *flags) tools += flag + '\0';
  }
  for (const auto& [path, text] : headers_) header_hashes_[path] = base::sha256(code_of(text));
  toolchain_ = base::sha256(tools);
  std::string objects;
  for (const auto* paths : {&config.framework, &config.recording}) {
    for (const std::string& path : *paths) objects += content_stamp(path, cache_);
  }
  framework_ = base::sha256(objects);
}

std::string Builder::folder_of_parts() const {
  std::set<std::string> all;
  for (const auto* paths : {&config_.framework, &config_.recording, &config_.radiance}) {
    all.insert(paths->begin(), paths->end());
  }
  for (const auto& [name, paths] : config_.callbacks) all.insert(paths.begin(), paths.end());
  for (const TaskConfig& task : config_.tasks) {
    all.insert(task.reference.begin(), task.reference.end());
  }
  std::string key;
  for (const std::string& path : all) key += path + '\0' + content_stamp(path, cache_);
  return kept_folder(config_.work, base::sha256(key), [&](const ToolFolder& place) {
    for (const std::string& path : all) place.copy(name_of_part(path), path);
  });
}

process::CommandResult Builder::run(const sandbox::Box& box, const std::string& what) const {
  const ToolRun run = run_tool(box, tier_, seconds_, cache_);
  const process::CommandResult& result = run.result;
  if (result.ok() || result.timed_out) return result;
  const auto give_up = [&](const std::string& why) {
    throw pt::Error(fmt::format("{} could not be judged: {}", what, why));
  };
  if (!run.started) {
    give_up("its box does not start (" + base::printable(first_line(result.output), 200) + ")");
  }
  if (run.killed) {
    give_up(
        "the compiler was killed, perhaps because no memory was left; give the machine more, or "
        "grade with --threads 1");
  }
  const std::string room = lack_of_room(cache_);
  if (!room.empty()) give_up(cache_ + " cannot be written (" + room + "); make room there");
  return result;
}

std::string Builder::object_key(const std::string& file, const std::string& text,
                                const Headers& headers) const {
  // A header that the task may not include cannot affect it.
  std::string seen;
  for (const auto& [name, content] : headers) {
    seen += name + '\0' + (content == headers_.at(name) ? header_hashes_.at(name) : "") + '\0';
  }
  return base::sha256(toolchain_ + seen + file + '\0' + text);
}

std::string Builder::folder_of(const Headers& headers) const {
  std::string whole;  // with comments, since messages quote lines
  for (const auto& [name, content] : headers) {
    whole.append(name).append(1, '\0').append(content).append(1, '\0');
  }
  return kept_folder(config_.work, base::sha256(whole), [&](const ToolFolder& place) {
    for (const auto& [name, content] : headers) place.put(name, content);
  });
}

sandbox::Box Builder::compiler_box(const ToolFolder& place, const TaskConfig& task,
                                   const std::string& file, const std::string& text,
                                   const std::string& tree) const {
  sandbox::Box box = tool_box(place);
  box.visible.push_back(tree);
  add(box, config_.compile_flags);
  box.command.insert(box.command.end(), kSubmissionFlags.begin(), kSubmissionFlags.end());
  const std::vector<std::string> precompiled = precompiled_.flags_for(task, text);
  add(box, precompiled);
  if (!precompiled.empty()) box.visible.push_back(precompiled_.folder());
  // An object contains no path of this machine, not even in the text of a failed assertion.
  add(box, {"-I" + tree, "-fmacro-prefix-map=" + tree + "/=", "-fdiagnostics-color=never", "-c",
            file, "-o", "task.o"});
  return box;
}

Built Builder::compile(const TaskConfig& task, const std::string& text) const {
  const Task& rules = task_of(task.slug);
  return compile_file(task, rules, task.file(), text, [&](const std::string& object) {
    return audit::audit(object, contract_of(task), rules);
  });
}

Built Builder::compile_examples(const TaskConfig& task, const std::string& text) const {
  const Task rules = rules_of_examples(task_of(task.slug));
  const std::string file = task.part + '/' + task.slug + ".examples.cpp";
  return compile_file(task, rules, file, text, [&](const std::string& object) {
    const std::string early = audit::runs_early(object);
    return early.empty() ? audit::audit(object, {}, rules) : early;
  });
}

Built Builder::compile_file(const TaskConfig& task, const Task& rules, const std::string& file,
                            const std::string& text,
                            const std::function<std::string(const std::string&)>& audit) const {
  const Headers headers = headers_for(rules, headers_);
  const std::string key = object_key(file, text, headers);
  const std::string path = cache_ + "/" + key + ".o";
  const std::string warnings_path = cache_ + "/" + key + ".warnings";
  if (fs::exists(path)) {
    mark_used(path);
    const bool warned = fs::exists(warnings_path);
    return {path, key, "", "", warned ? pt::read_file(warnings_path) : ""};
  }
  const std::string tree = folder_of(headers);
  const ToolFolder place(pt::temporary_name(cache_ + "/" + key + ".tree"));
  place.put(file, text);
  sandbox::Box box = compiler_box(place, task, file, text, tree);
  const auto compiled = [&] {
    process::CommandResult result = run(box, task.slug);
    result.output = in_project(result.output, tree, precompiled_.folder());
    return result;
  };
  process::CommandResult result = compiled();
  const std::string warnings = warnings_of(result.output, file);
  if (result.ok() && warnings.find(kNoReturn) != std::string::npos) {
    box.command.insert(box.command.end(), kTrapFlags.begin(), kTrapFlags.end());
    result = compiled();
  }
  if (!result.ok()) return {"", key, first_error(result, seconds_), "", ""};
  const base::Submitted object = place.take("task.o", kMaxObject);
  if (!object.present || !object.rejected.empty()) {
    return {"", key, "", "the compiled object is not accepted: " + object.rejected, ""};
  }
  const std::string reason = audit(object.text);
  if (!reason.empty()) return {"", key, "", reason, ""};
  if (!warnings.empty()) pt::write_file(warnings_path, warnings);
  keep(path, audit::with_state_marked(object.text));
  return {path, key, "", "", warnings};
}

Built Builder::link(const Paths& objects, const std::string& key, bool recorded) const {
  const std::string whole = base::sha256(framework_ + toolchain_ + key + (recorded ? "r" : "s"));
  const std::string path = cache_ + "/" + whole + ".worker";
  if (fs::exists(path)) {
    mark_used(path);
    return {path, whole, "", "", ""};
  }
  process::CommandResult result;
  for (const bool first : {true, false}) {
    const ToolFolder place(pt::temporary_name(cache_ + "/" + whole + ".tree"));
    result = run_linker(place, objects, recorded);
    if (result.ok()) {
      keep_worker(place, path);
      return {path, whole, "", "", ""};
    }
    // A machine runs out of memory only for a moment, so a second attempt usually succeeds.
    if (first) expect_linker(recorded);
  }
  result.output = without_parts(result.output, folder_of_parts());
  return {"", whole, first_error(result, seconds_), "", ""};
}

// A linker reads a submission's objects, so it works in a box, as a compiler does. It reads copies,
// and may change only the copies of the submission's objects.
process::CommandResult Builder::run_linker(const ToolFolder& place, const Paths& objects,
                                           bool recorded) const {
  sandbox::Box box = tool_box(place);
  const std::string parts = folder_of_parts();
  box.visible.push_back(parts);
  int number = 0;
  const auto add_objects = [&](const Paths& paths) {
    for (const std::string& object : paths) {
      const std::string part = parts + '/' + name_of_part(object);
      if (fs::exists(part)) {
        box.command.push_back(part);
        continue;
      }
      const std::string name = fmt::format("{}.o", ++number);
      place.copy(name, object);
      box.command.push_back(name);
    }
  };
  add(box, config_.compile_flags);
  add_objects(config_.framework);
  if (recorded) add_objects(config_.recording);
  add_objects(objects);
  add(box, config_.link_flags);
  if (recorded) add(box, config_.recording_flags);
  add(box, {"-o", "worker"});
  return run(box, "what was compiled");
}

void Builder::expect_linker(bool recorded) const {
  Paths objects = config_.radiance;
  for (const TaskConfig& task : config_.tasks) {
    objects.insert(objects.end(), task.reference.begin(), task.reference.end());
  }
  const ToolFolder place(pt::temporary_name(cache_ + "/reference.tree"));
  const process::CommandResult result = run_linker(place, objects, recorded);
  if (result.ok()) return;
  throw pt::Error("the judge's own link fails: " + base::printable(result.output, 300));
}

sandbox::Box Builder::tool_box(const ToolFolder& place) const {
  sandbox::Box box{{config_.compiler},
                   {"PATH=/usr/bin:/bin", "LANG=C.UTF-8", "TMPDIR=."},
                   {},
                   {},
                   place.folder(),
                   true,
                   kCompilerLimits};
  box.limits.cpu_seconds = seconds_;
  if (config_.compiler_version.starts_with("GNU ")) report_parts(box, place);
  return box;
}

}  // namespace grader::build
