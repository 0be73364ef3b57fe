#include "site/pages.h"

#include "pt/error.h"
#include "pt/file.h"
#include "site/figures.h"
#include "site/links.h"
#include "writeup/markdown.h"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <kainjow/mustache.hpp>

namespace site {

namespace fs = std::filesystem;
using kainjow::mustache::data;

namespace {

// Pages about grading and scenes to which the handbook and the instructors' pages lead.
const std::vector<std::string> kDocs{
    "docs/commands.md",  "docs/conventions.md", "docs/platforms.md",
    "docs/rendering.md", "docs/results.md",     "docs/verdicts.md",
    "docs/view.md",      "docs/scenes.md",      "scenes/README.md"};
// The links at the top of each page.
const std::vector<std::pair<std::string, std::string>> kTop{
    {"site/front.md", "Firstlight"},       {"student/README.md", "Handbook"},
    {"student/1_rays/README.md", "1"},     {"student/2_bvh/README.md", "2"},
    {"student/3_direct/README.md", "3"},   {"student/4_global/README.md", "4"},
    {"student/5_adaptive/README.md", "5"}, {"docs/instructors/README.md", "For instructors"}};

std::string with_ending(const std::string& path, std::size_t ending, const std::string& other) {
  return path.substr(0, path.size() - ending) + other;
}

// The file of a page in the site, by its path in the project.
std::string file_of(const std::string& path) {
  if (path == "site/front.md") return "index.html";
  if (path.ends_with("/README.md")) return with_ending(path, 9, "index.html");
  return path.ends_with(".md") ? with_ending(path, 3, ".html") : path + ".html";
}

std::string title_of(const std::string& text) {
  const std::size_t start = text.find("# ");
  return start == text.npos ? "" : text.substr(start + 2, text.find('\n', start) - start - 2);
}

class Site {
 public:
  Site(const Sources& sources, fs::path folder)
      : sources_(sources),
        folder_(std::move(folder)),
        figures_(read_figures(sources.root / "site/figures.json")) {}

  void write() {
    find_pages();
    copy_shared();
    for (const std::string& page : pages_) write_text(page);
    while (!contracts_.empty()) write_contract(contracts_.extract(contracts_.begin()).value());
  }

 private:
  void find_pages() {
    pages_ = {"site/front.md"};
    pages_.insert(kDocs.begin(), kDocs.end());
    for (const char* part : {"student", "docs/instructors"}) {
      for (const auto& entry : fs::recursive_directory_iterator(sources_.root / part)) {
        const fs::path path = entry.path().lexically_relative(sources_.root);
        // What a learner writes for a write-up is theirs.
        const bool own = path.string().starts_with("student/writeup/");
        if (path.extension() == ".md" && !own) pages_.insert(path.string());
      }
    }
  }

  void copy(const fs::path& from, const fs::path& to) {
    fs::create_directories((folder_ / to).parent_path());
    fs::copy(from, folder_ / to,
             fs::copy_options::recursive | fs::copy_options::overwrite_existing);
  }

  void copy_shared() {
    copy(sources_.root / "site/page/site.css", "site/site.css");
    copy_samples();
    for (const LiveFigure& figure : figures_) copy(sources_.root / figure.still, figure.still);
    if (sources_.live.empty()) return;
    copy(sources_.live, "site/reference.js");
    copy(sources_.root / "site/page/live.js", "site/live.js");
    for (const LiveFigure& figure : figures_) {
      const std::string script = figure.name + ".js";
      copy(sources_.root / "site/page/figures" / script, "site/figures/" + script);
    }
  }

  // A report has links to the handbook and the contracts, from the place where it was made.
  void copy_samples() {
    if (sources_.samples.empty()) return;
    copy(sources_.samples, "samples");
    const fs::path report = folder_ / "samples/report.html";
    const fs::path made =
        fs::path(sources_.samples).lexically_relative(sources_.root) / "report.html";
    pt::write_file(report, with_addresses(pt::read_file(report), [&](const std::string& link) {
                     return address(made, "samples/report.html", link);
                   }));
  }

  // The address in the site's file for a link of a page of the project; empty if the site does not have it.
  std::string address(const std::string& page, const std::string& page_file,
                      const std::string& link) {
    if (link.find("://") != link.npos || link.starts_with("data:")) return link;
    const std::size_t hash = std::min(link.find('#'), link.size());
    if (hash == 0) return link;
    const fs::path from = fs::path(page_file).parent_path();
    const fs::path here = fs::path(page).parent_path();
    const std::string path = (here / link.substr(0, hash)).lexically_normal();
    // The front page links to samples as the site has them.
    const std::string in_site = (from / link.substr(0, hash)).lexically_normal();
    if (in_site.starts_with("samples/")) return fs::exists(folder_ / in_site) ? link : "";
    std::string file;
    if (pages_.contains(path)) {
      file = file_of(path);
    } else if (path.starts_with("pt/") && path.ends_with(".h")) {
      if (!written_.contains(path)) contracts_.insert(path);
      file = file_of(path);
    } else if (path.ends_with(".png") || path.ends_with(".svg")) {
      if (!fs::exists(sources_.root / path)) throw pt::Error(page + ": there is no " + path);
      copy(sources_.root / path, path);
      file = path;
    } else {
      return "";
    }
    return fs::path(file).lexically_relative(from.empty() ? "." : from).string() +
           link.substr(hash);
  }

  void write_page(const std::string& page, const std::string& title, const std::string& content) {
    const std::string file = file_of(page);
    std::string up;
    for (const char c : file) up += c == '/' ? "../" : "";
    data links{data::type::list};
    for (const auto& [path, name] : kTop) {
      data item;
      item.set("href", up + file_of(path));
      item.set("name", name);
      item.set("about", name.size() == 1 ? "Part " + name : "");
      item.set("current", path == page);
      links.push_back(item);
    }
    data out;
    out.set("title", title);
    out.set("up", up);
    out.set("pages", links);
    out.set("content", with_figures(content, page, up, figures_, !sources_.live.empty()));
    kainjow::mustache::mustache form(pt::read_file(sources_.root / "site/page/page.html"));
    fs::create_directories((folder_ / file).parent_path());
    pt::write_file(folder_ / file, form.render(out));
  }

  void write_text(const std::string& page) {
    const std::string text = pt::read_file(sources_.root / page);
    const std::string html =
        with_addresses(with_ids(writeup::html_from_markdown(text, writeup::Tags::kept)),
                       [&](const std::string& link) { return address(page, file_of(page), link); });
    write_page(page, title_of(text), in_frames(html));
  }

  // Tables that are wider than a phone scroll by themselves.
  static std::string in_frames(std::string html) {
    for (const auto& [from, to] :
         {std::pair{
              "<table>",
              "<div class=\"scroll\" tabindex=\"0\" role=\"group\" aria-label=\"Table\"><table>"},
          std::pair{"</table>", "</table></div>"}}) {
      for (std::size_t at = 0; (at = html.find(from, at)) != html.npos;
           at += std::string(to).size()) {
        html.replace(at, std::string(from).size(), to);
      }
    }
    return html;
  }

  void write_contract(const std::string& path) {
    written_.insert(path);
    const std::string text = pt::read_file(sources_.root / path);
    write_page(path, path,
               fmt::format("<h1>{}</h1>\n<pre tabindex=\"0\"><code>{}</code></pre>\n", path,
                           writeup::escaped(text)));
  }

  const Sources& sources_;
  fs::path folder_;
  std::vector<LiveFigure> figures_;
  std::set<std::string> pages_;                // paths in the project
  std::set<std::string> contracts_, written_;  // headers to be written, and those that are
};

}  // namespace

void write_site(const Sources& sources, const fs::path& folder) { Site(sources, folder).write(); }

}  // namespace site
