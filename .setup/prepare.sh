# Sourced by lessons/run and tests/run: installs missing packages, configures and builds into build/.
# Do not run it by itself. The current folder must be the root of the project.

# wanted FILE...: prints the packages in the lists.
wanted() { sed -e 's/#.*//' -e '/^[[:space:]]*$/d' "$@"; }

# missing FILE...: prints the packages in the lists that are not installed.
missing() {
  wanted "$@" | while read -r package; do
    [ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null)" = installed ] || printf '%s ' "$package"
  done
}

# install_packages FILE...: installs the packages as root or through sudo; otherwise says what to install and stops.
install_packages() {
  if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    for tool in c++ cmake ninja pkg-config gnuplot; do
      command -v "$tool" >/dev/null || absent="${absent:-}$tool "
    done
    for library in ginac cln gsl mpfr; do
      pkg-config --exists "$library" 2>/dev/null || absent="${absent:-}$library "
    done
    [ -z "${absent:-}" ] && return 0
    echo "This is not a Debian system, and these are missing: ${absent}" >&2
    echo "Install the contents of these Debian packages, then run this again:" >&2
    wanted "$@" | sed 's/^/  /' >&2
    exit 2
  fi
  packages=$(missing "$@")
  [ -z "$packages" ] && return 0
  become=""
  if [ "$(id -u)" != 0 ]; then
    if ! command -v sudo >/dev/null; then
      echo "These packages are missing. Install them as root, because sudo is not available:" >&2
      echo "  apt-get update && apt-get install $packages" >&2
      exit 2
    fi
    become=sudo
  fi
  echo "Installing: $packages" >&2
  $become apt-get update -qq >&2 &&
    $become env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $packages >&2 || {
    echo "The installation failed. Install the packages by hand: apt-get install $packages" >&2
    exit 2
  }
}

# build TESTS [TARGET...]: configures if needed, builds, and prints nothing unless something fails. TESTS is ON or OFF;
# a build folder with tests keeps them.
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
    [ -f build/build.log ] || echo "Building. The first build takes some minutes; build/build.log shows the progress" >&2
    cmake --build build --target "$@" >build/build.log 2>&1 || { cat build/build.log >&2; exit 3; }
  fi
}
