#!/usr/bin/env python3
"""pages.py SITE: every link of the site leads to a file and a heading of it, nothing is loaded from elsewhere, every picture has words,
and no line of a solution is in it. Prints the addresses of the pages."""
import glob
import html.parser
import os
import re
import sys

SITE = sys.argv[1]
complaints = []


class Page(html.parser.HTMLParser):
    def __init__(self, text):
        super().__init__()
        self.links, self.ids = [], set()
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        found = dict(attributes)
        self.ids.add(found.get("id"))
        if tag == "img" and found.get("alt") is None:
            complaints.append(f"a picture has no words: {found.get('src', '')[:80]}")
        for name in ("href", "src"):
            if found.get(name):
                self.links.append((found[name], tag))


def lines(pattern):
    for file in glob.glob(pattern, recursive=True):
        with open(file, encoding="utf-8") as text:
            yield from (line.strip() for line in text)


files = [os.path.join(folder, name) for folder, _, names in os.walk(SITE) for name in names]
texts = {file: open(file, encoding="utf-8").read() for file in sorted(files) if not file.endswith((".png", ".svg"))}
pages = {file: Page(text) for file, text in texts.items() if file.endswith(".html")}
count = 0
for file, page in pages.items():
    for link, tag in page.links:
        if re.match(r"(https?|data):", link):
            if tag != "a" and not link.startswith("data:"):
                complaints.append(f"{file} loads {link}")
            continue
        count += 1
        name, _, anchor = link.partition("#")
        target = os.path.normpath(os.path.join(os.path.dirname(file), name)) if name else file
        if not os.path.isfile(target):
            complaints.append(f"{file}: nothing at {link}")
        elif anchor and anchor not in pages[target].ids:
            complaints.append(f"{file}: no heading for {link}")
# Code that the handbook, the headers and the stubs do not show.
public = set(lines("student/**/*.*[dp]")) | set(lines("pt/**/*.h"))
solutions = {line for line in lines("reference/*/*.cpp") if len(line) > 40 and line.endswith(";")} - public
for file, text in texts.items():
    plain = text.replace("&lt;", "<").replace("&gt;", ">").replace("&quot;", '"').replace("&amp;", "&")
    complaints += [f"{file} has a line of a solution: {line}" for line in solutions if line in plain]
size = sum(os.path.getsize(file) for file in files)
if size > 12e6:
    complaints.append(f"the site has {size} bytes")
if count < 500 or len(solutions) < 50:
    complaints.append(f"only {count} links and {len(solutions)} lines of solutions were looked at")
for complaint in complaints:
    print(complaint, file=sys.stderr)
print("\n".join(pages))
sys.exit(len(complaints) > 0)
