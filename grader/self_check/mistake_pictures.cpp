#include "grader/self_check/mistake_pictures.h"

#include "grader/images/sample_map_verdict.h"
#include "grader/judge/files.h"
#include "grader/judge/name_by_pictures.h"
#include "grader/judge/picture_trial.h"
#include "grader/judge/sha256.h"
#include "pt/file.h"
#include "pt/image/image_io.h"

#include <algorithm>
#include <filesystem>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace grader {

namespace {

namespace fs = std::filesystem;

fs::path golden_of(const Config& config, const std::string& recipe) {
  return config.root + "/golden/" + recipe + ".exr";
}

BlockMeans golden_blocks(const Config& config, const Recipe& recipe) {
  BlockMeans blocks = block_means(pt::read_exr(golden_of(config, recipe.name)));
  if (recipe.adaptive) {
    add_counts(blocks, usual_counts(
                           read_reference(config.root + "/golden/" + recipe.name + "_rates.json")));
  }
  return blocks;
}

// What the judge would find in the pictures of one solution.
std::vector<PictureResult> judged_again(const KnownMistake& seen,
                                        const std::map<std::string, BlockMeans>& goldens,
                                        std::span<const KnownMistake> known) {
  std::vector<PictureResult> pictures;
  for (const auto& [recipe, picture] : seen.pictures) {
    const auto golden = goldens.find(recipe);
    if (golden == goldens.end()) continue;
    JudgedPicture judged;
    if (picture.known) {
      judged.outcome =
          picture.blocks ? JudgedPicture::Outcome::wrong : JudgedPicture::Outcome::right;
      judged.blocks = picture.blocks;
    }
    const Likeness found = compare(recipe, picture.recipe_hash, judged, golden->second, known);
    PictureResult& result = pictures.emplace_back();
    result.like = found.like;
    result.unlike = found.unlike;
  }
  return pictures;
}

struct Count {
  std::size_t seen = 0, right = 0, wrong = 0;
  std::vector<std::string> others;  // with what else it could be, or "no picture"
};

void count(const KnownMistake& seen, const std::vector<std::string>& names, Count& into) {
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

bool is_seen(const KnownMistake& mistake) {
  return std::any_of(mistake.pictures.begin(), mistake.pictures.end(),
                     [](const auto& each) { return each.second.blocks || !each.second.known; });
}

}  // namespace

std::string content_of(const std::string& text) { return sha256(text).substr(0, 12); }

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

KnownMistake::Picture picture_of(const PictureResult& result) {
  const JudgedPicture picture = judged_picture(result);
  return {recipe_hash(result.golden), picture.blocks,
          picture.outcome != JudgedPicture::Outcome::none};
}

KnownMistake::Picture known_picture(const PictureResult& result) {
  KnownMistake::Picture picture = picture_of(result);
  picture.known = picture.blocks.has_value();
  return picture;
}

void write_known(const Config& config, const std::string& out) {
  std::vector<KnownMistake> all;
  for (const std::string& file : {known_mistakes(config), known_path(out)}) {
    for (KnownMistake& mistake : read_mistakes(file, "")) add(all, std::move(mistake));
  }
  std::sort(all.begin(), all.end(), [](const KnownMistake& a, const KnownMistake& b) {
    return std::pair(a.task, a.name) < std::pair(b.task, b.name);
  });
  std::string text;
  for (KnownMistake& mistake : all) {
    const fs::path file =
        fs::path(config.root) / "grader/tasks" / mistake.task / "wrong" / (mistake.name + ".cpp");
    if (!fs::exists(file) || content_of(read_file(file)) != mistake.content) continue;
    mistake.sentence = sentence_of(read_file(file));
    std::erase_if(mistake.pictures, [&](const auto& each) {
      const fs::path golden = golden_of(config, each.first);
      return !fs::exists(golden) || recipe_hash(golden) != each.second.recipe_hash;
    });
    if (is_seen(mistake)) text += to_line(mistake);
  }
  pt::write_file(known_mistakes(config), text);
}

std::string table_of_names(const Config& config, const std::vector<Recipe>& recipes,
                           const std::string& out) {
  std::map<std::string, BlockMeans> goldens;
  for (const Recipe& recipe : recipes) goldens[recipe.name] = golden_blocks(config, recipe);
  std::string table =
      "| task | seen | named right | named wrongly | not named |\n"
      "|---|---|---|---|---|\n";
  Count all;
  for (const std::string& task : task_slugs()) {
    const std::vector<KnownMistake> known = read_mistakes(known_mistakes(config), task);
    Count of_task;
    for (const KnownMistake& seen : read_mistakes(seen_path(out), task)) {
      if (!is_seen(seen)) continue;
      count(seen, candidates(judged_again(seen, goldens, known)), of_task);
    }
    all.seen += of_task.seen;
    all.right += of_task.right;
    all.wrong += of_task.wrong;
    table += fmt::format("| {} | {} | {} | {} | {} |\n", task, of_task.seen, of_task.right,
                         of_task.wrong, fmt::join(of_task.others, ", "));
  }
  return table + fmt::format("| all | {} | {} | {} | |\n", all.seen, all.right, all.wrong);
}

}  // namespace grader
