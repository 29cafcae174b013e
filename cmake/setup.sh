# SPDX-License-Identifier: Apache-2.0
# Shared by ./run and ./test: what has to be installed, and how a target is built. To be sourced with $top set.

build_packages=(g++ cmake ninja-build ccache libcli11-dev nlohmann-json3-dev libstb-dev libeigen3-dev)
test_packages=(clang clang-format clang-tidy llvm-14 libclang-rt-dev libgtest-dev googletest
  libbenchmark-dev librapidcheck-dev emscripten nodejs python3 git ca-certificates admesh)
judge_packages=(assimp-utils blender python3-numpy godot3-server prusa-slicer chromium)

# need_packages NAME...: installs those that are missing with apt; says what it does.
need_packages() {
  local missing=() name installed become=()
  if ! command -v dpkg-query >/dev/null; then
    echo "This is no Debian system: make sure there is what these packages hold: $*" >&2
    return 0
  fi
  installed=$(dpkg-query -W -f='${Package} ${db:Status-Status}\n' "$@" 2>/dev/null || true)
  for name in "$@"; do
    grep -qx "$name installed" <<<"$installed" || missing+=("$name")
  done
  [ ${#missing[@]} -eq 0 ] && return 0
  if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null; then
      echo "Please install these packages as root, then try again:" >&2
      echo "  apt-get install ${missing[*]}" >&2
      return 1
    fi
    become=(sudo)
  fi
  echo "Installing: ${missing[*]}" >&2
  "${become[@]}" env DEBIAN_FRONTEND=noninteractive apt-get update -q >&2
  "${become[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -y -q --no-install-recommends "${missing[@]}" >&2
}

# build_target PRESET TARGET...: configures and builds; silent when there is nothing to do, all output on failure.
build_target() {
  local preset=$1 folder=$top/build/$1 log
  shift
  mkdir -p "$folder"
  log=$folder/build.log
  if [ ! -f "$folder/build.ninja" ]; then
    [ -t 2 ] && echo "Building ($preset) for the first time; this takes a minute or two ..." >&2
    if ! (cd "$top" && cmake --preset "$preset") >"$log" 2>&1; then
      cat "$log" >&2
      return 1
    fi
  fi
  if ! ninja -C "$folder" -j "$(nproc)" "$@" >"$log" 2>&1; then
    grep -v '^\[[0-9]*/[0-9]*\] ' "$log" >&2
    return 1
  fi
}
