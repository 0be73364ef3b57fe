#include "grader/self_check/mistake_pictures.h"

#include "grader/base/files.h"
#include "grader/base/sha256.h"
#include "grader/judge/name_by_pictures.h"
#include "grader/judge/picture_trial.h"
#include "grader/pictures/sample_map_verdict.h"
#include "pt/file.h"
#include "pt/image/image_io.h"

#include <algorithm>
#include <filesystem>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace grader::self_check {

namespace {

namespace fs = std::filesystem;

fs::path golden_of(const judge::Config& config, const std::string& recipe) {
  return config.root + "/golden/" + recipe + ".exr";
}

pictures::BlockMeans golden_blocks(const judge::Config& config, const pictures::Recipe& recipe) {
  pictures::BlockMeans blocks = pictures::block_means(pt::read_exr(golden_of(config, recipe.name)));
  if (recipe.adaptive) {
    pictures::add_counts(blocks, pictures::usual_counts(pictures::read_reference(
                                     config.root + "/golden/" + recipe.name + "_rates.json")));
  }
  return blocks;
}

// The verdicts of the judge on the pictures of one solution.
std::vector<results::PictureResult> judged_again(
    const pictures::KnownMistake& seen, const std::map<std::string, pictures::BlockMeans>& goldens,
    std::span<const pictures::KnownMistake> known) {
  std::vector<results::PictureResult> pictures;
  for (const auto& [recipe, picture] : seen.pictures) {
    const auto golden = goldens.find(recipe);
    if (golden == goldens.end()) continue;
    pictures::JudgedPicture judged;
    if (picture.known) {
      judged.outcome = picture.blocks ? pictures::JudgedPicture::Outcome::wrong
                                      : pictures::JudgedPicture::Outcome::right;
      judged.blocks = picture.blocks;
    }
    const pictures::Likeness found =
        pictures::compare(recipe, picture.recipe_hash, judged, golden->second, known);
    results::PictureResult& result = pictures.emplace_back();
    result.like = found.like;
    result.unlike = found.unlike;
  }
  return pictures;
}

struct Count {
  std::size_t seen = 0, right = 0, wrong = 0;
  std::vector<std::string> others;  // with what else it could be, or "no picture"
};

void count(const pictures::KnownMistake& seen, const std::vector<std::string>& names, Count& into) {
  ++into.seen;
  const bool found = std::count(names.begin(), names.end(), seen.name) > 0;
  if (names.size() == 1) {
    ++(found ? into.right : into.wrong);
    if (!found) into.others.push_back(fmt::format("**{} named {}**", seen.name, names[0]));
    return;
  }
  std::vector<std::string> twins;
  for (const std::string& name : names) {
    if (name != seen.name) twins.push_back(name);
  }
  into.others.push_back(names.empty() ? seen.name
                                      : fmt::format("{} {}= {}", seen.name, found ? "" : "! ",
                                                    fmt::join(twins, " = ")));
}

bool is_seen(const pictures::KnownMistake& mistake) {
  return std::any_of(mistake.pictures.begin(), mistake.pictures.end(),
                     [](const auto& each) { return each.second.blocks || !each.second.known; });
}

}  // namespace

std::string content_of(const std::string& text) { return base::sha256(text).substr(0, 12); }

std::string sentence_of(const std::string& text) {
  std::istringstream in(text);
  std::string sentence, line;
  std::getline(in, line);
  while (std::getline(in, line) && line.starts_with("// ")) {
    sentence += (sentence.empty() ? "" : " ") + line.substr(3);
    if (line.ends_with('.')) break;
  }
  return sentence;
}

std::string known_path(const std::string& out) { return out + ".known.jsonl"; }
std::string seen_path(const std::string& out) { return out + ".seen.jsonl"; }

pictures::KnownMistake::Picture picture_of(const results::PictureResult& result) {
  const pictures::JudgedPicture picture = pictures::judged_picture(result);
  return {pictures::recipe_hash(result.golden), picture.blocks,
          picture.outcome != pictures::JudgedPicture::Outcome::none};
}

pictures::KnownMistake::Picture known_picture(const results::PictureResult& result) {
  pictures::KnownMistake::Picture picture = picture_of(result);
  picture.known = picture.blocks.has_value();
  return picture;
}

void write_known(const judge::Config& config, const std::string& out) {
  std::vector<pictures::KnownMistake> all;
  for (const std::string& file : {judge::known_mistakes(config), known_path(out)}) {
    for (pictures::KnownMistake& mistake : pictures::read_mistakes(file, ""))
      pictures::add(all, std::move(mistake));
  }
  std::sort(all.begin(), all.end(),
            [](const pictures::KnownMistake& a, const pictures::KnownMistake& b) {
              return std::pair(a.task, a.name) < std::pair(b.task, b.name);
            });
  std::string text;
  for (pictures::KnownMistake& mistake : all) {
    const fs::path file =
        fs::path(config.root) / "grader/tasks" / mistake.task / "wrong" / (mistake.name + ".cpp");
    if (!fs::exists(file) || content_of(base::read_file(file)) != mistake.content) continue;
    mistake.sentence = sentence_of(base::read_file(file));
    std::erase_if(mistake.pictures, [&](const auto& each) {
      const fs::path golden = golden_of(config, each.first);
      return !fs::exists(golden) || pictures::recipe_hash(golden) != each.second.recipe_hash;
    });
    if (is_seen(mistake)) text += to_line(mistake);
  }
  pt::write_file(judge::known_mistakes(config), text);
}

std::string table_of_names(const judge::Config& config,
                           const std::vector<pictures::Recipe>& recipes, const std::string& out) {
  std::map<std::string, pictures::BlockMeans> goldens;
  for (const pictures::Recipe& recipe : recipes)
    goldens[recipe.name] = golden_blocks(config, recipe);
  std::string table =
      "| task | seen | named right | named wrongly | not named |\n"
      "|---|---|---|---|---|\n";
  Count all;
  for (const std::string& task : pictures::task_slugs()) {
    const std::vector<pictures::KnownMistake> known =
        pictures::read_mistakes(judge::known_mistakes(config), task);
    Count of_task;
    for (const pictures::KnownMistake& seen : pictures::read_mistakes(seen_path(out), task)) {
      if (!is_seen(seen)) continue;
      count(seen, judge::candidates(judged_again(seen, goldens, known)), of_task);
    }
    all.seen += of_task.seen;
    all.right += of_task.right;
    all.wrong += of_task.wrong;
    table += fmt::format("| {} | {} | {} | {} | {} |\n", task, of_task.seen, of_task.right,
                         of_task.wrong, fmt::join(of_task.others, ", "));
  }
  return table + fmt::format("| all | {} | {} | {} | |\n", all.seen, all.right, all.wrong);
}

}  // namespace grader::self_check
