#!/usr/bin/env python3
"""english.py [--show]: measures the sentences of the pages that people read first, and holds each page to bounds: words per
sentence, long sentences, "of which", "one" as a noun that has to be looked up, and sentences whose subject is missing because it is
the command above them. Tables, code and headings do not count. --show prints each sentence that counts against a page."""
import glob
import os
import re
import sys

os.chdir(os.path.join(os.path.dirname(os.path.abspath(__file__)), "../.."))
PAGES = ["README.md", "CONTRIBUTING.md", *sorted(glob.glob("docs/instructors/*.md")), "docs/README.md", "docs/commands.md", "docs/rendering.md",
         "docs/platforms.md", "docs/conventions.md", "docs/four_bugs.md", "scenes/README.md", "scripts/editions/handout_README.md", *sorted(glob.glob("student/*.md")), *sorted(glob.glob("student/*/README.md"))]
MEAN = 14.5  # words per sentence, of a page
LONG = 32  # words; a page has at most one such sentence in fifty, and none of half as many again
RELATIVE = re.compile(r"\b(of|in|by|for|from|to|with|on|at) (which|whom|whose)\b")
AFTER = r"(?=[.,;:!?)]|$| (that|which|who|whose|is|are|was|were|has|have|had|can|does|do|in|on|at|with|for|and|or|but|by|from|to|than|as|if|alone)\b)"
ONE = re.compile(r"\b(ones\b|(?<!one by )(?<!than )one\b" + AFTER + ")", re.I)


def prose(text):
    """Paragraphs of a page, and whether each follows a command."""
    text = re.sub(r"<!--.*?-->", "", text, flags=re.S)
    text = re.sub(r"!\[[^\]]*\]\([^)]*\)|<img [^>]*>", "", text)
    text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", text)
    paragraph, code, after_code = [], False, False
    for line in [*text.split("\n"), ""]:
        if line.startswith("    ") and not paragraph:
            code = "./run" in line
            continue
        starts = re.match(r"\s*([-*]|\d+\.) ", line)
        if (not line.strip() or line.startswith(("|", "#")) or starts) and paragraph:
            yield " ".join(paragraph), after_code
            paragraph, code = [], False
        if line.strip() and not line.startswith(("|", "#")):
            if not paragraph:
                after_code, code = code, False
            paragraph.append(line[starts.end():] if starts else line.strip())


def sentences(text):
    """(sentence, whether it follows a command)"""
    for paragraph, after_command in prose(text):
        paragraph = re.sub(r"`[^`]*`", "x", paragraph).replace("**", "").replace("*", "")
        for i, sentence in enumerate(re.split(r"(?<=[.!?:])[\"')]*\s+(?=[A-Z0-9x(\"'])", paragraph)):
            if sentence.strip():
                yield sentence.strip(), after_command and i == 0


def words(sentence):
    return len(re.findall(r"[A-Za-z0-9][\w'’.,/-]*", sentence))


def faults(page):
    """What a page does too often: (what, how often, bound, the sentences)."""
    all_of = list(sentences(open(page, encoding="utf-8").read()))
    counts = [words(sentence) for sentence, _ in all_of]
    mean = sum(counts) / max(1, len(counts))
    long = [sentence for sentence, _ in all_of if words(sentence) > LONG]
    yield "words per sentence", mean, MEAN, []
    yield f"sentences of more than {LONG} words", len(long), max(1, len(counts) // 50), long
    yield f"sentences of more than {LONG * 3 // 2} words", *([len(some := [s for s in long if words(s) > LONG * 3 // 2]), 0, some])
    yield "'of which'", *([len(some := [s for s, _ in all_of if RELATIVE.search(s)]), max(1, len(counts) // 40), some])
    yield "'one' as a noun", *([len(some := [s for s, _ in all_of if ONE.search(s)]), max(1, len(counts) // 40), some])
    yield "no subject", *([len(some := [s for s, starts in all_of if starts and re.match(r"[a-z]{2,}[ ,]", s)]), 0, some])


def main():
    failures = 0
    for page in PAGES:
        for what, count, bound, some in faults(page):
            if "--show" in sys.argv:
                for sentence in some:
                    print(f"{page}: {what}: {sentence}")
            if count > bound:
                failures += 1
                print(f"{page}: {what}: {count:.4g}, at most {bound}; see english.py --show")
    print(f"{len(PAGES)} pages, {failures} complaints")
    return failures > 0


if __name__ == "__main__":
    sys.exit(main())
