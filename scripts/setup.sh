# shellcheck shell=bash
# Installs the system packages that the project needs, or prints one command if it may not install them. `./run`
# includes this file.
# shellcheck disable=SC2154 # root, build and command are those of ./run

# package_manager: prints the first package manager that is here.
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

# packages_for USES: prints Debian's names of the packages for these uses, as scripts/packages.txt calls them.
packages_for() { awk -v "uses= $1 " '!/^#/ && index(uses, " " $2 " ") { print $1 }' "$root/scripts/packages.txt"; }

# name_for MANAGER PACKAGE: prints the manager's name for it; nothing if it is not needed; ? if there is none.
name_for() {
  if [ "$1" = apt-get ]; then
    echo "$2"
  else
    awk -v manager="$1" -v package="$2" '
      /^# package / { for (i = 3; i <= NF; ++i) if ($i == manager) column = i - 1 }
      $1 == package { if ($column != "-") print $column }' "$root/scripts/packages.txt"
  fi
}

# find_missing MANAGER USES: sets `missing` to the packages for these uses that are not installed, with the manager's
# names, and `unknown` to those that it does not have.
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
  done < <(packages_for "$2")
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

# how_to_install MANAGER STAMP: prints one sentence for a person who has to do it by hand.
how_to_install() {
  local sudo=''
  case $1:$(id -u) in
    brew:* | *:0) ;;
    *) sudo='sudo ' ;;
  esac
  printf 'These packages are missing. Install them first (or ask an administrator): %s%s %s' \
    "$sudo" "$(install_command "$1")" "${missing[*]}"
  [ ${#unknown[@]} -eq 0 ] ||
    printf '; we know no %s package for these, so get them from their authors, or use the container (see .devcontainer/): %s' \
      "$1" "${unknown[*]}"
  # Names change, and the compiler also finds packages with other names.
  [ "$1" = apt-get ] || printf '; if all are installed under other names, continue with: mkdir -p %s && touch %s' "$build" "$2"
}

# may_install: succeeds if apt-get can be run, perhaps with a password on this terminal.
may_install() {
  [ "$(id -u)" -eq 0 ] || { command -v sudo >/dev/null && { sudo -n true 2>/dev/null || [ -t 0 ]; }; }
}

install_missing() {
  local sudo=()
  [ "$(id -u)" -eq 0 ] || sudo=(sudo)
  echo "Firstlight needs packages of the system. These are missing, and are now installed with apt-get:" >&2
  echo "  ${missing[*]}" >&2
  [ ${#sudo[@]} -eq 0 ] || sudo -v || fail "$(how_to_install apt-get "$stamp")"
  { with_progress "reading the list of packages" "$build/packages.log" ${sudo[@]+"${sudo[@]}"} apt-get update &&
    with_progress "installing ${#missing[@]} packages" "$build/packages.log" ${sudo[@]+"${sudo[@]}"} \
      env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends "${missing[@]}"; } ||
    fail "apt-get could not install ${missing[*]} (see build/packages.log); install them and try again"
}

# setup [USES]: installs missing packages, and remembers it, so that the next call costs nothing. It makes no file
# before it is certain to succeed. Without USES: what students need, and what grading a class needs.
setup() {
  local uses=${1:-student class} stamp manager missing unknown
  stamp=$build/packages.$(packages_for "$uses" | cksum | cut -d' ' -f1)
  [ -e "$stamp" ] && return
  manager=$(package_manager)
  [ -n "$manager" ] ||
    fail "./run does not know the package manager of this system. Install these packages (with Debian's names), then type mkdir -p $build && touch $stamp:" \
      "$(packages_for "$uses" | tr '\n' ' ')"
  find_missing "$manager" "$uses"
  if [ ${#missing[@]} -gt 0 ] || [ ${#unknown[@]} -gt 0 ]; then
    { [ "$manager" = apt-get ] && may_install; } || fail "$(how_to_install "$manager" "$stamp")"
    lock_tree
    find_missing "$manager" "$uses" # another ./run may have installed them
    [ ${#missing[@]} -eq 0 ] || install_missing
  fi
  lock_tree
  touch "$stamp"
}
