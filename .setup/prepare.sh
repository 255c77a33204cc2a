# Sourced by lessons/run and tests/run: installs what is missing, configures and builds into build/.
# Never run by itself. Expects the current folder to be the project's root.

# wanted FILE...: the packages that the lists name.
wanted() { sed -e 's/#.*//' -e '/^[[:space:]]*$/d' "$@"; }

# missing FILE...: those of them that are not installed.
missing() {
  wanted "$@" | while read -r package; do
    [ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null)" = installed ] || printf '%s ' "$package"
  done
}

# install_packages FILE...: as root, or through sudo; else says what to install and stops.
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
    wanted "$@" | sed 's/^/  /' >&2
    exit 2
  fi
  packages=$(missing "$@")
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

# build TESTS [TARGET...]: configures where needed, builds, and prints nothing unless something fails. TESTS is ON or OFF;
# a build folder that has the tests keeps them.
build() {
  local tests=$1 configured=
  shift
  mkdir -p build
  if [ ! -f build/build.ninja ]; then
    cmake --preset default -DREDERIVE_WERROR="${REDERIVE_WERROR:-OFF}" -DREDERIVE_BUILD_TESTS="$tests" >build/configure.log 2>&1 || configured=no
  elif [ "$tests" = ON ] && grep -q '^REDERIVE_BUILD_TESTS:BOOL=OFF$' build/CMakeCache.txt; then
    cmake -DREDERIVE_BUILD_TESTS=ON build >build/configure.log 2>&1 || configured=no
  fi
  [ -z "$configured" ] || { cat build/configure.log >&2; exit 3; }
  if [ -t 2 ]; then
    cmake --build build --target "$@" >&2 || exit 3
  else
    [ -f build/build.log ] || echo "Building: the first time takes some minutes; build/build.log says how far it is" >&2
    cmake --build build --target "$@" >build/build.log 2>&1 || { cat build/build.log >&2; exit 3; }
  fi
}
