# shellcheck shell=bash
# The packages that the project needs from the system: missing ones are installed where that is allowed, and else
# named in one command. `./run` includes this file.
# shellcheck disable=SC2154 # root, build and command are those of ./run

# package_manager: the first that is here.
package_manager() {
  local manager
  for manager in apt-get dnf pacman apk brew; do
    ! command -v "$manager" >/dev/null || { echo "$manager"; return; }
  done
}

is_installed() {
  case $1 in
    apt-get) dpkg-query -W -f='${Status}' "$2" 2>/dev/null | grep -q 'ok installed' ;;
    dnf) rpm -q "$2" >/dev/null 2>&1 ;;
    pacman) pacman -Q "$2" >/dev/null 2>&1 ;;
    apk) apk info -e "$2" >/dev/null 2>&1 ;;
    brew) brew list --versions "$2" >/dev/null 2>&1 ;;
  esac
}

# name_for MANAGER PACKAGE: the manager's name for it; empty where it is not needed; ? where it has none.
name_for() {
  if [ "$1" = apt-get ]; then
    echo "$2"
  else
    awk -v manager="$1" -v package="$2" '
      /^# package / { for (i = 3; i <= NF; ++i) if ($i == manager) column = i - 1 }
      $1 == package { if ($column != "-") print $column }' "$root/cmake/packages-elsewhere.txt"
  fi
}

# find_missing MANAGER LIST...: the packages of the lists that are not installed, in `missing`, by the manager's names;
# and those that it does not have, in `unknown`.
find_missing() {
  local package name
  missing=() unknown=()
  while read -r package; do
    name=$(name_for "$1" "$package")
    case $name in
      '') ;;
      '?') unknown+=("$package") ;;
      *) is_installed "$1" "$name" || missing+=("$name") ;;
    esac
  done < <(grep -hv '^#' "${@:2}")
}

install_command() {
  case $1 in
    apt-get) echo "apt-get install -y --no-install-recommends" ;;
    dnf) echo "dnf install" ;;
    pacman) echo "pacman -S --needed" ;;
    apk) echo "apk add" ;;
    brew) echo "brew install" ;;
  esac
}

# how_to_install MANAGER STAMP: one sentence for somebody who has to do it by hand.
how_to_install() {
  local sudo=''
  case $1:$(id -u) in
    brew:* | *:0) ;;
    *) sudo='sudo ' ;;
  esac
  printf 'These packages are missing, and have to be installed first (by somebody who may): %s%s %s' \
    "$sudo" "$(install_command "$1")" "${missing[*]}"
  [ ${#unknown[@]} -eq 0 ] ||
    printf '; for these %s has no package that we know, so get them from their authors, or use the container (see .devcontainer/): %s' \
      "$1" "${unknown[*]}"
  # Names change, and what is here under another one is found by the compiler.
  [ "$1" = apt-get ] || printf '; if all is here under other names, go on with: mkdir -p %s && touch %s' "$build" "$2"
}

# may_install: succeeds if apt-get can be run, if need be after a password on this terminal.
may_install() {
  [ "$(id -u)" -eq 0 ] || { command -v sudo >/dev/null && { sudo -n true 2>/dev/null || [ -t 0 ]; }; }
}

install_missing() {
  local sudo=()
  [ "$(id -u)" -eq 0 ] || sudo=(sudo)
  echo "Firstlight is built with packages of the system. These are missing, and are now installed with apt-get:" >&2
  echo "  ${missing[*]}" >&2
  [ ${#sudo[@]} -eq 0 ] || sudo -v || fail "$(how_to_install apt-get "$stamp")"
  { with_progress "reading the list of packages" "$build/packages.log" ${sudo[@]+"${sudo[@]}"} apt-get update &&
    with_progress "installing ${#missing[@]} packages" "$build/packages.log" ${sudo[@]+"${sudo[@]}"} \
      env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends "${missing[@]}"; } ||
    fail "apt-get could not install ${missing[*]} (see build/packages.log); install them and try again"
}

# setup [LIST]: remembers that all were there, so that the next call costs nothing. Makes nothing before it is
# certain that it can go on. Without LIST: the packages that everybody needs, and those for grading a class.
setup() {
  local lists=("$root/cmake/${1:-packages.txt}") stamp manager missing unknown
  [ $# -gt 0 ] || [ ! -e "$root/cmake/packages-class.txt" ] || lists+=("$root/cmake/packages-class.txt")
  stamp=$build/packages.$(cat "${lists[@]}" | cksum | cut -d' ' -f1)
  [ -e "$stamp" ] && return
  manager=$(package_manager)
  [ -n "$manager" ] ||
    fail "./run knows no package manager of this system. Install these libraries (the names are those of Debian), then type mkdir -p $build && touch $stamp:" \
      "$(grep -hv '^#' "${lists[@]}" | tr '\n' ' ')"
  find_missing "$manager" "${lists[@]}"
  if [ ${#missing[@]} -gt 0 ] || [ ${#unknown[@]} -gt 0 ]; then
    { [ "$manager" = apt-get ] && may_install; } || fail "$(how_to_install "$manager" "$stamp")"
    lock_tree
    find_missing "$manager" "${lists[@]}" # another ./run may have been faster
    [ ${#missing[@]} -eq 0 ] || install_missing
  fi
  lock_tree
  touch "$stamp"
}
