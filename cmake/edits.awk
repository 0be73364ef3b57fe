# The one reader of mistakes that are kept as edits: those of learners (grader/tasks/*/mistakes.txt) and those with which the
# tests of the framework are tested (tests/mutants/mutants.txt).
#
#     awk -v root=DIR [-v reference=FILE] -v needed="LABEL ..." -v WHAT -f cmake/edits.awk TABLE
#
# An entry is a paragraph of fields. A label fills eight columns, and the text behind it may go on in lines that are indented by eight:
#
#     name    far_root_reported
#     base    right/textbook.cpp       the file that is changed: from the folder `root`; `reference` is the file of that name, and
#                                      the name of another entry stands for that entry's changed file
#     include <limits>                 a header that the change needs, if any
#     old     t1 : t2;                 stands exactly once in the file,
#     new     t2 : t1;                 and this takes its place. There may be several such pairs, or none: the file as it is.
#     vary    1e-9 => 3e-9             a text that stands once in the changed file, and what a close relative has in its place
#
# Other labels have a meaning for those who use the table. A line `breaks  finds_the_near_side` above entries holds for all of them, up
# to the next such line. A line `base` above all entries is the base of those that have none. `guard` in place of `name` is a mistake that
# nobody makes, which guards a promise: it is never named, and has neither sentence nor hint.
#
# WHAT is one of
#     out=DIR -v file=NAME    makes DIR/<name>/NAME for each entry, if it has changed, and prints the names
#     list="LABEL ..."        prints these fields of each entry, with a tab between them
#     relatives=DIR -v file=NAME  makes DIR/<name>/NAME, the relative, for each entry that has `vary`, and prints the names
#     only=NAME               prints the changed file of this entry
#
# If an entry does not fit, one sentence names it with file and line, and the exit status is 2.

BEGIN { split("name guard breaks says hint base include old new vary target test", labels); for (i in labels) known[labels[i]] = 1 }

function fail(line, text) {
  printf "%s:%d: %s\n", table, line, text > "/dev/stderr"
  failed = 1
  exit 2
}

{ table = FILENAME }
/^#/ { next }
/^[ \t]*$/ { ++empty; next }
/^        / {
  if (label == "") fail(FNR, "this line continues nothing; an entry begins with 'name    ...'")
  for (; empty > 0; --empty) add("\n")
  add("\n" substr($0, 9))
  next
}
{
  above = empty > 0 || NR == 1
  empty = 0
  label = $1
  if (!(label in known) || substr($0, 1, 8) !~ /^[a-z]+ *$/)
    fail(FNR, "'" $1 "' is not a label; write one of name, guard, breaks, says, hint, base, include, old, new, vary, target, test, and fill eight columns")
  if (label == "guard") { label = "name"; guard[count + 1] = 1 }
  if (label == "name") { line_of[++count] = FNR; if ($2 in named) fail(FNR, "there are two of the name " $2); named[$2] = count }
  if (label == "breaks") {
    if (!above) fail(FNR, "'breaks' stands above the entries that it holds for, between empty lines")
    promise = substr($0, 9)
    label = ""
    next
  }
  if (label == "base" && count == 0) { usual_base = substr($0, 9); next }
  if (count == 0) fail(FNR, "an entry begins with its name; write 'name    ...'")
  if (label == "name") { field[count, "breaks"] = promise; field[count, "base"] = usual_base }
  if (label == "old") { ++edits[count]; field[count, "old"] = "is there" }
  if (label == "base") field[count, "base"] = ""
  add(substr($0, 9))
}

# Appends to the field that is being read.
function add(text) {
  if (label == "old") old[count, edits[count]] = old[count, edits[count]] text
  else if (label == "new") new[count, edits[count]] = new[count, edits[count]] text
  else if (label == "include") { if (text != "") includes[count] = includes[count] "#include " text "\n" }
  else field[count, label] = field[count, label] text
}

function contents(path,    line, text) {
  while ((getline line < path) > 0) text = text line "\n"
  close(path)
  return text
}

function base_of(i) { return field[i, "base"] == "reference" ? reference : root "/" field[i, "base"] }

function occurrences(text, part,    n, at) {
  while ((at = index(text, part)) > 0) { ++n; text = substr(text, at + length(part)) }
  return n + 0
}

# Returns the file of an entry after its edits.
function changed(i,    path, text, before, k, at) {
  path = base_of(i)
  if (!(path in kept)) {
    if (busy[i]++) fail(line_of[i], field[i, "name"] ": its base is an edit of itself; name a file")
    text = field[i, "base"] in named ? changed(named[field[i, "base"]]) : contents(path)
    kept[path] = text
  }
  text = before = kept[path]
  if (text == "") fail(line_of[i], field[i, "name"] ": there is no " path "; say where the code is now")
  for (k = 1; k <= edits[i]; ++k) {
    if (old[i, k] == new[i, k]) fail(line_of[i], field[i, "name"] ": old and new are the same; change something")
    if (occurrences(before, old[i, k]) != 1 || occurrences(text, old[i, k]) != 1)
      fail(line_of[i], field[i, "name"] ": '" old[i, k] "' is " occurrences(before, old[i, k]) " times in " field[i, "base"] \
        " (" occurrences(text, old[i, k]) " after the edits above it); write a text that is there once")
    at = index(text, old[i, k])
    text = substr(text, 1, at - 1) new[i, k] substr(text, at + length(old[i, k]))
  }
  if (includes[i] != "") {
    at = index(text, "#include ")
    text = substr(text, 1, at - 1) includes[i] substr(text, at)
  }
  return text
}

# Returns the file of a close relative of an entry.
function varied(i,    text, parts) {
  text = bare(changed(i))
  if (split(field[i, "vary"], parts, " => ") != 2 || occurrences(text, parts[1]) != 1)
    fail(line_of[i], field[i, "name"] ": 'vary' is not 'A => B', or A is not once in the changed file")
  return "// breaks: " field[i, "name"] "\n" substr(text, 1, index(text, parts[1]) - 1) parts[2] \
    substr(text, index(text, parts[1]) + length(parts[1]))
}

# Returns the file with the description of its mistake above the code.
function commented(i) {
  return "// breaks: " field[i, "breaks"] "\n" (guard[i] ? "" : comment(field[i, "says"]) comment("hint: " field[i, "hint"])) bare(changed(i))
}

# Returns a file without the comment above its code.
function bare(text) {
  while (text ~ /^\/\//) text = substr(text, index(text, "\n") + 1)
  return text
}

function comment(text) { gsub(/\n/, "\n// ", text); return "// " text "\n" }

END {
  if (failed) exit 2
  many = split(needed, must)
  for (i = 1; i <= count; ++i) for (k = 1; k <= many; ++k)
    if (field[i, must[k]] == "" && !(guard[i] && must[k] ~ /^(says|hint)$/)) fail(line_of[i], field[i, "name"] ": it has no '" must[k] "'; write it")
  many = split(list, shown)
  folder = out relatives
  if (folder != "" && count > 0) {
    for (i = 1; i <= count; ++i) if (out != "" || field[i, "vary"] != "") folders = folders " '" folder "/" field[i, "name"] "'"
    if (folders != "") system("mkdir -p" folders)
  }
  for (i = 1; i <= count; ++i) {
    text = changed(i)
    near = field[i, "vary"] == "" ? "" : varied(i)
    if (many > 0) {
      row = ""
      for (k = 1; k <= many; ++k) row = row (k > 1 ? "\t" : "") field[i, shown[k]]
      gsub(/\n/, " ", row)
      print row
    } else if (folder != "") {
      text = out != "" ? commented(i) : near
      if (text == "") continue
      path = folder "/" field[i, "name"] "/" file
      if (contents(path) != text) { printf "%s", text > path; close(path) }
      print field[i, "name"]
    } else if (only == field[i, "name"]) printf "%s", text
  }
}
