#include "grader/service/intake/owner.h"

#include "grader/service/intake/canvas_form.h"
#include "grader/service/intake/entry_path.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <set>

namespace grader::intake {

namespace {

using Forms = std::vector<Found>;  // one name, as each platform would read it; the last is Canvas

// The forms of one platform. The first that fits a name counts.
using OfPlatform = std::vector<const NameForm*>;

std::vector<OfPlatform> platforms_of(const std::vector<NameForm>& table) {
  std::vector<OfPlatform> platforms;
  for (const NameForm& form : table) {
    const auto known = std::ranges::find(platforms, form.platform,
                                         [](const OfPlatform& each) { return each[0]->platform; });
    if (known == platforms.end())
      platforms.push_back({&form});
    else
      known->push_back(&form);
  }
  return platforms;
}

Found read_by_first(const OfPlatform& forms, const std::string& name, bool is_folder) {
  for (const NameForm* form : forms) {
    if (Found label = read_by(*form, name, is_folder)) return label;
  }
  return {};
}

// Reads uncertain names of Canvas again, now that the numbers of the others' files are known.
void read_again(std::map<std::string, Forms>& all) {
  Numbers certain;
  for (const auto& [name, forms] : all) {
    const Found& label = forms.back();
    if (!label || !label->certain || label->text) continue;
    certain.least = std::min(certain.least, number(label->order));
    certain.largest = std::max(certain.largest, number(label->order));
    const bool is_number = label->id.find_first_not_of("0123456789") == label->id.npos;
    if (is_number && !label->id.empty())
      certain.largest_id = std::max(certain.largest_id, number(label->id));
  }
  for (auto& [name, forms] : all) {
    Found& label = forms.back();
    if (label && !label->certain) label = canvas_among(name, certain);
  }
}

// An export of Canvas has one number per file and one name per ID. Other files may have names of
// the same form.
bool is_consistent(const std::map<std::string, Forms>& all) {
  std::set<std::string> numbers;
  std::map<std::string, std::string> learners;
  const auto fits = [&](bool certain) {
    return std::ranges::all_of(all, [&](const auto& each) {
      const Found& label = each.second.back();
      if (!label || label->certain != certain) return true;
      return (label->text || numbers.insert(label->order).second) &&
             learners.try_emplace(label->id, label->name).first->second == label->name;
    });
  };
  // A learner can only make the reading of a name uncertain.
  return fits(true) && (!learners.empty() || fits(false));
}

// The forms, the one that most names have first.
std::vector<std::size_t> by_number(const std::map<std::string, Forms>& all) {
  std::vector<std::size_t> order;
  const std::size_t forms = all.empty() ? 0 : all.begin()->second.size();
  for (std::size_t i = 0; i < forms; ++i) order.push_back(i);
  std::ranges::stable_sort(order, std::greater{}, [&](std::size_t i) {
    return std::ranges::count_if(all, [&](const auto& each) { return each.second[i].has_value(); });
  });
  return order;
}

// The text before the name is the beginning that all have in common, up to the last `between`.
void split_same(const std::vector<Label*>& labels, const std::string& between) {
  std::string common = labels.empty() ? "" : labels[0]->name;
  for (const Label* label : labels) {
    const auto differs = std::ranges::mismatch(common, label->name).in1;
    common.erase(differs, common.end());
  }
  const std::size_t last = common.rfind(between);
  if (last == common.npos) return;
  const std::size_t end = last + between.size();
  for (Label* label : labels) {
    if (end < label->name.size()) label->name.erase(0, end);
  }
}

using Place = std::vector<std::string>;

bool is_ascii(const std::string& text) {
  return std::all_of(text.begin(), text.end(),
                     [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

// The number of times that files of an owner begin in an archive.
struct Begun {
  int files = 0, folders = 0;
  int rows = 0;  // groups of adjacent entries in the folder

  // An archive may lack entries for folders.
  bool twice() const { return files > 1 || folders > 1 || (folders == 0 && rows > 1); }
};

}  // namespace

Labels::Labels(const std::vector<std::string>& files, const std::vector<std::string>& folders,
               const std::vector<NameForm>& table) {
  const std::vector<OfPlatform> platforms = platforms_of(table);
  std::map<std::string, Forms> all;
  for (const std::vector<std::string>* names : {&files, &folders}) {
    const bool are_folders = names == &folders;
    for (const std::string& name : *names) {
      const auto [entry, is_new] = all.try_emplace(name);
      if (!is_new) continue;
      for (const OfPlatform& forms : platforms)
        entry->second.push_back(read_by_first(forms, name, are_folders));
      entry->second.push_back(are_folders ? Found() : canvas(name));  // it exports no folders
    }
  }
  read_again(all);
  if (!is_consistent(all)) {
    for (auto& [name, forms] : all) forms.back().reset();
  }
  const std::vector<std::size_t> order = by_number(all);
  std::vector<std::vector<Label*>> of_platform(platforms.size() + 1);
  for (auto& [name, forms] : all) {
    const auto form = std::ranges::find_if(
        order, [&forms = forms](std::size_t i) { return forms[i].has_value(); });
    if (form == order.end()) continue;
    Label& label = labels_[name] = *forms[*form];
    label.before = name.substr(0, name.size() - std::min(name.size(), label.file.size()));
    of_platform[*form].push_back(&label);
  }
  for (std::size_t i = 0; i < platforms.size(); ++i) {
    const std::string between = between_same_and_name(*platforms[i][0]);
    if (!between.empty()) split_same(of_platform[i], between);
  }
}

std::optional<Label> Labels::of(const std::string& name) const {
  const auto found = labels_.find(name);
  return found == labels_.end() ? std::nullopt : std::optional(found->second);
}

Owners::Owners(const std::vector<Place>& paths, const std::vector<NameForm>& table)
    : depth_(folders_around(paths)) {
  std::vector<std::string> files, folders;
  for (const Place& path : paths) {
    if (path.size() > depth_) (path.size() == depth_ + 1 ? files : folders).push_back(path[depth_]);
  }
  labels_ = Labels(files, folders, table);
  in_doubt_ = may_be_two(paths);
}

std::string Owners::key(const Place& place) const {
  const std::string& part = place[std::min(depth_, place.size() - 1)];
  const std::optional<Label> label = labels_.of(part);
  return label ? label->key : part;
}

std::vector<Place> Owners::may_be_two(const std::vector<Place>& paths) const {
  std::map<Place, Begun> all;
  Place before;
  for (const Place& path : paths) {
    const std::size_t count = std::min(depth_ + 1, path.size());
    const Place place(path.begin(), path.begin() + static_cast<std::ptrdiff_t>(count));
    if (!is_ascii(place.back()) && !labels_.of(place.back())) {
      Begun& begun = all[place];
      if (path.size() == count) {
        ++begun.files;
      } else if (path.size() == count + 1 && path.back() == kFolderItself) {
        ++begun.folders;
      } else if (place != before) {
        ++begun.rows;
      }
    }
    before = place;
  }
  std::vector<Place> twice;
  for (const auto& [place, begun] : all) {
    if (begun.twice()) twice.push_back(place);
  }
  return twice;
}

}  // namespace grader::intake
