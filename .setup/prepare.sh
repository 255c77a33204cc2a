# Sourced by lessons/run and tests/run: installs what is missing, configures and builds into build/.
# Never run by itself. Expects the current folder to be the project's root.

# wanted FILE: the packages that a list names.
wanted() { sed -e 's/#.*//' -e '/^[[:space:]]*$/d' "$1"; }

# missing FILE: those of them that dpkg does not have.
missing() {
  wanted "$1" | while read -r package; do
    [ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null)" = installed ] || printf '%s ' "$package"
  done
}

# install_packages FILE: as root, or through sudo; else says what to install and stops.
install_packages() {
  if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    for tool in c++ cmake ninja pkg-config gnuplot; do
      command -v "$tool" >/dev/null || absent="${absent:-}$tool "
    done
    for library in ginac cln gsl mpfr; do
      pkg-config --exists "$library" 2>/dev/null || absent="${absent:-}$library "
    done
    [ -z "${absent:-}" ] && return 0
    echo "This is no Debian system, and something is missing here: ${absent}" >&2
    echo "Please install what these Debian packages contain, then run this again:" >&2
    wanted "$1" | sed 's/^/  /' >&2
    exit 2
  fi
  packages=$(missing "$1")
  [ -z "$packages" ] && return 0
  become=""
  if [ "$(id -u)" != 0 ]; then
    if ! command -v sudo >/dev/null; then
      echo "These packages are missing, and there is neither root nor sudo to install them with. As root:" >&2
      echo "  apt-get update && apt-get install $packages" >&2
      exit 2
    fi
    become=sudo
  fi
  echo "Installing: $packages" >&2
  $become apt-get update -qq >&2 &&
    $become env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $packages >&2 || {
    echo "The installation failed. Please install by hand: apt-get install $packages" >&2
    exit 2
  }
}

# build [TARGET...]: configures where needed, builds, and keeps quiet unless something goes wrong.
build() {
  mkdir -p build
  if [ ! -f build/build.ninja ]; then
    cmake --preset default >build/configure.log 2>&1 || { cat build/configure.log >&2; exit 3; }
  fi
  if [ -t 2 ]; then
    cmake --build build --target "$@" >&2 || exit 3
  else
    [ -f build/build.log ] || echo "Building: the first time takes some minutes; build/build.log says how far it is" >&2
    cmake --build build --target "$@" >build/build.log 2>&1 || { cat build/build.log >&2; exit 3; }
  fi
}
