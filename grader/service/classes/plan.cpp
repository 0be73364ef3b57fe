#include "grader/service/classes/plan.h"

#include "grader/base/files.h"
#include "grader/base/json_text.h"
#include "grader/base/sha256.h"
#include "grader/results/points.h"
#include "grader/service/classes/folders.h"
#include "grader/service/classes/identity.h"
#include "grader/service/intake/boxed_readers.h"
#include "pt/end_of_program.h"
#include "pt/error.h"
#include "pt/file.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <random>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

namespace grader::classes {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

// An unreadable seed is an error: else everybody would be judged again, and nobody would know why.
std::optional<std::uint64_t> seed_in(const std::string& folder) {
  const std::string path = folder + "/seed";
  if (!fs::exists(path)) return std::nullopt;
  std::uint64_t seed = 0;
  if (std::ifstream(path) >> seed) return seed;
  throw pt::Error(path + " holds no number; write --seed and the number that the reports name");
}

std::uint64_t seed_for(const PlanRequest& request) {
  const std::string path = request.out + "/seed";
  std::uint64_t seed = 0;
  if (request.seed) {
    seed = *request.seed;
  } else if (const auto kept = seed_in(request.out)) {
    return *kept;
  } else {
    const auto former = request.former.empty() ? std::nullopt : seed_in(request.former);
    seed = former ? *former : std::random_device{}();
  }
  pt::write_file(path, std::to_string(seed) + "\n");
  return seed;
}

// The first year of the skeleton of a clone; else an empty text.
std::string year_of(const intake::HandedIn& by) {
  return by.course ? door::year_of(*by.course) : "";
}

// A text that is equal for equal task files, and equal examples where these earn points; empty if there are no task files.
std::string content_of(const build::Config& config, const results::Points& points,
                       const intake::HandedIn& by) {
  const std::string root = base::submission_root(by.folder);
  std::string all = year_of(by);
  bool any = false;
  for (const build::TaskConfig& task : config.tasks) {
    const base::Submitted file = base::read_submitted(root, task.part, task.slug);
    any = any || file.present;
    all += fmt::format("{} {} {}\n", file.present, file.rejected, base::sha256(file.text));
    if (points.at(task.slug).examples > 0)
      all += base::sha256(base::read_submitted(root, task.part, task.slug + ".examples").text);
  }
  return any ? base::sha256(all) : "";
}

// Groups equal submissions. A submission with nothing to judge gets a problem.
std::vector<Equal> groups_of(const build::Config& config,
                             std::vector<intake::HandedIn>& everybody) {
  std::vector<Equal> groups;
  std::map<std::string, std::size_t> known;
  const results::Points points = results::load_points(config.root + "/grader/points.json");
  for (std::size_t i = 0; i < everybody.size(); ++i) {
    intake::HandedIn& by = everybody[i];
    if (!by.problem.empty()) continue;
    std::string content;
    try {
      content = content_of(config, points, by);
    } catch (const std::exception& error) {
      by.problem = pt::sentence_of(error);
      continue;
    }
    if (content.empty()) {
      by.problem =
          fmt::format("it holds none of the files that are to be handed in ({}.cpp and so on)",
                      config.tasks[0].slug);
      continue;
    }
    const auto [entry, is_new] = known.try_emplace(content, groups.size());
    if (is_new) groups.emplace_back();
    groups[entry->second].push_back(i);
  }
  return groups;
}

std::vector<Chunk> chunks_of(const std::vector<Equal>& groups, std::size_t size) {
  if (size == 0) size = (groups.size() + kMaxChunks - 1) / kMaxChunks;
  std::vector<Chunk> chunks;
  for (const Equal& group : groups) {
    if (chunks.empty() || chunks.back().size() == size) chunks.emplace_back();
    chunks.back().push_back(group);
  }
  return chunks;
}

// A file's name may contain any bytes, JSON only UTF-8: other names become lists of numbers.
json text_json(const std::string& text) {
  try {
    json as_text = text;
    (void)as_text.dump();
    return as_text;
  } catch (const json::exception&) {
    return std::vector<std::uint8_t>(text.begin(), text.end());
  }
}

std::string text_from(const json& from) {
  if (from.is_string()) return from.get<std::string>();
  const auto bytes = from.get<std::vector<std::uint8_t>>();
  return {bytes.begin(), bytes.end()};
}

json to_json(const intake::HandedIn& by) {
  return {{"name", text_json(by.name)},
          {"id", text_json(by.id)},
          {"folder", text_json(by.folder)},
          {"late", by.late},
          {"problem", text_json(by.problem)},
          {"platform", static_cast<int>(by.platform)},
          {"feedback", text_json(by.feedback)},
          {"note", text_json(by.note)},
          {"handed_in", text_json(by.handed_in)},
          {"days_late", by.days_late},
          {"absent", by.absent},
          {"course", year_of(by)}};
}

// The file, and the members of the plan in it, that tell who is who in an anonymous class.
constexpr const char* kNames = "/plan.names";
constexpr std::array kOfAll{"real_names", "former_names", "unclaimed"};
constexpr std::array kOfEach{"id", "feedback"};

// Takes these members out of the plan.
json taken_out(json& plan) {
  json names{{"everybody", json::array()}};
  const auto take = [](json& from, json& to, const char* key) {
    to[key] = from.at(key);
    from.erase(key);
  };
  for (const char* key : kOfAll) take(plan, names, key);
  for (json& by : plan["everybody"]) {
    json& each = names["everybody"].emplace_back(json::object());
    for (const char* key : kOfEach) take(by, each, key);
  }
  return names;
}

void put_back(const json& names, json& plan) {
  for (const char* key : kOfAll) plan[key] = names.at(key);
  for (std::size_t i = 0; i < plan.at("everybody").size(); ++i)
    plan["everybody"][i].update(names.at("everybody").at(i));
}

json to_json(const Rules& rules) {
  return {{"roster", text_json(rules.roster)},
          {"due", text_json(rules.due)},
          {"grace", rules.grace},
          {"penalty", rules.penalty},
          {"overrides", text_json(rules.overrides)},
          {"attempt", rules.attempt}};
}

Rules rules_from(const json& from) {
  return {text_from(from.at("roster")),    text_from(from.at("due")),
          from.at("grace").get<int>(),     from.at("penalty").get<int>(),
          text_from(from.at("overrides")), from.value("attempt", "last")};
}

// The rules of the earlier grading, so that nobody's extension or points by hand are lost because an
// option was not written again.
Rules earlier_rules(const PlanRequest& request) {
  for (const std::string& folder : {request.out, request.former}) {
    const std::string path = folder + "/plan.json";
    if (folder.empty() || !fs::exists(path)) continue;
    const json plan = json::parse(pt::read_file(path), nullptr, false);
    return plan.contains("rules") ? rules_from(plan["rules"]) : Rules();
  }
  return {};
}

// The instructor's forms of names before those of the project.
std::vector<intake::NameForm> name_forms(const build::Config& config, const PlanRequest& request) {
  std::vector<intake::NameForm> all;
  for (const std::string& path : {request.forms, config.root + "/grader/name_forms.csv"}) {
    if (path.empty()) continue;
    for (intake::NameForm& form : intake::read_name_forms(path)) all.push_back(std::move(form));
  }
  return all;
}

intake::HandedIn handed_in_from(const json& from) {
  return {text_from(from.at("name")),
          text_from(from.at("id")),
          text_from(from.at("folder")),
          from.at("late").get<bool>(),
          text_from(from.at("problem")),
          static_cast<intake::Platform>(from.at("platform").get<int>()),
          text_from(from.at("feedback")),
          text_from(from.at("note")),
          door::course_since(from.at("course").get<std::string>()),
          text_from(from.at("handed_in")),
          from.at("days_late").get<int>(),
          from.at("absent").get<bool>()};
}

// Throws if the plan is invalid: another program may have written it.
void check_plan(const ClassPlan& plan) {
  const auto check = [](bool holds, const char* what) {
    if (!holds) throw pt::Error(what);
  };
  check(plan.real_names.empty() || plan.real_names.size() == plan.everybody.size(),
        "it has not as many real names as submissions");
  check(plan.former_names.empty() || plan.former_names.size() == plan.everybody.size(),
        "it has not as many former names as submissions");
  const auto can_be_file = [](const std::string& name) {
    return name != "." && name != ".." && name.find('/') == name.npos &&
           name.find('\0') == name.npos;
  };
  for (const std::string& name : plan.former_names) {
    check(can_be_file(name), "a submission's former name cannot be that of a file");
  }
  for (const intake::HandedIn& by : plan.everybody) {
    check(!by.name.empty() && can_be_file(by.name), "a submission's name cannot be that of a file");
  }
  for (const Chunk& chunk : plan.chunks) {
    for (const Equal& equal : chunk) {
      check(!equal.empty(), "a chunk has nobody in it");
      for (const std::size_t i : equal) {
        check(i < plan.everybody.size(), "a chunk has a submission that there is not");
      }
    }
  }
}

}  // namespace

std::string host_name() {
  char name[256] = "";
  gethostname(name, sizeof name - 1);
  return name;
}

std::vector<intake::HandedIn> with_real_names(const ClassPlan& plan) {
  std::vector<intake::HandedIn> all = plan.everybody;
  for (std::size_t i = 0; i < plan.real_names.size(); ++i) all[i].name = plan.real_names[i];
  return all;
}

ClassPlan make_plan(const build::Config& config, const std::string& programs,
                    const PlanRequest& request, const intake::Progress& progress) {
  ClassPlan plan;
  plan.id = random_text();
  plan.input = request.input;
  plan.words = request.words;
  plan.seed = seed_for(request);
  plan.host = host_name();
  plan.former = request.former;
  plan.assignment = request.assignment;
  plan.worksheet = request.worksheet;
  plan.likeness = !request.no_likeness;
  plan.rules = rules_for(request.rules, earlier_rules(request));
  std::vector<intake::TaskFile> tasks;
  for (const build::TaskConfig& task : config.tasks) tasks.push_back({task.part, task.slug});
  const std::string unpacked = fs::absolute(folder_to_unpack(request.out));
  const std::vector<intake::NameForm> forms = name_forms(config, request);
  intake::HandedInByAll all = intake::handed_in(
      request.input, unpacked, tasks,
      intake::boxed_readers(config.root, config.work, programs, request.must_isolate, forms), forms,
      progress, plan.rules.attempt == "first" ? intake::Attempt::first : intake::Attempt::last);
  plan.everybody = std::move(all.everybody);
  plan.unclaimed = std::move(all.unclaimed);
  plan.work_is_unclaimed = all.work_is_unclaimed;
  for (intake::HandedIn& by : plan.everybody) {
    if (!by.folder.empty()) by.folder = fs::absolute(by.folder);
  }
  if (!plan.worksheet.empty()) add_times_of_moodle(plan.worksheet, plan.everybody);
  plan.remarks = apply_rules(plan.rules, plan.everybody, request.anonymous);
  (void)read_overrides(plan.rules.overrides, plan.everybody);  // checked before anything is judged
  if (request.anonymous) hide_names(plan, request.out);
  if (!plan.former.empty()) plan.former_names = former_names(plan);
  keep_task_files(config, plan, unpacked);
  if (request.anonymous) hide_folders(plan, unpacked);
  plan.chunks = chunks_of(groups_of(config, plan.everybody), request.chunk_size);
  return plan;
}

void write_plan(const ClassPlan& plan, const std::string& out) {
  json all{{"id", plan.id},
           {"input", text_json(plan.input)},
           {"words", plan.words},
           {"seed", plan.seed},
           {"host", plan.host},
           {"former", text_json(plan.former)},
           {"assignment", text_json(plan.assignment)},
           {"worksheet", text_json(plan.worksheet)},
           {"rules", to_json(plan.rules)},
           {"likeness", plan.likeness},
           {"salt", plan.salt},
           {"chunks", plan.chunks},
           {"everybody", json::array()},
           {"real_names", json::array()},
           {"former_names", json::array()},
           {"unclaimed", json::array()},
           {"work_is_unclaimed", plan.work_is_unclaimed}};
  for (const intake::HandedIn& by : plan.everybody) all["everybody"].push_back(to_json(by));
  for (const std::string& name : plan.real_names) all["real_names"].push_back(text_json(name));
  for (const std::string& name : plan.former_names) all["former_names"].push_back(text_json(name));
  for (const std::string& name : plan.unclaimed) all["unclaimed"].push_back(text_json(name));
  if (!plan.salt.empty()) pt::write_file(out + kNames, taken_out(all).dump(1) + "\n");
  pt::write_file(out + "/plan.json", all.dump(1) + "\n");
}

ClassPlan read_plan(const std::string& out) {
  const std::string path = out + "/plan.json";
  if (!fs::exists(path)) {
    throw pt::Error(out + " holds no plan; make one: ./run grade-class plan CLASS --out " + out);
  }
  try {
    json all = json::parse(pt::read_file(path));
    if (!all.at("salt").get<std::string>().empty())
      put_back(json::parse(pt::read_file(out + kNames)), all);
    ClassPlan plan;
    plan.input = text_from(all.at("input"));
    plan.words = all.at("words").get<std::vector<std::string>>();
    plan.seed = all.at("seed").get<std::uint64_t>();
    plan.host = all.at("host").get<std::string>();
    plan.former = text_from(all.at("former"));
    plan.assignment = text_from(all.at("assignment"));
    plan.id = all.at("id").get<std::string>();
    plan.worksheet = text_from(all.at("worksheet"));
    plan.rules = rules_from(all.at("rules"));
    plan.likeness = all.at("likeness").get<bool>();
    plan.salt = all.at("salt").get<std::string>();
    plan.chunks = all.at("chunks").get<std::vector<Chunk>>();
    for (const json& by : all.at("everybody")) plan.everybody.push_back(handed_in_from(by));
    for (const json& name : all.at("real_names")) plan.real_names.push_back(text_from(name));
    for (const json& name : all.at("former_names")) plan.former_names.push_back(text_from(name));
    for (const json& name : all.at("unclaimed")) plan.unclaimed.push_back(text_from(name));
    plan.work_is_unclaimed = all.at("work_is_unclaimed").get<bool>();
    check_plan(plan);
    return plan;
  } catch (const std::exception& error) {
    throw pt::Error(fmt::format("{}: {}; make the plan again (./run grade-class plan)", path,
                                base::words_of(error)));
  }
}

}  // namespace grader::classes
