# SPDX-License-Identifier: Apache-2.0
# Shared by ./run and ./test: what has to be installed, and how a target is built. To be sourced with $top set.

build_packages=(g++ cmake ninja-build ccache libcli11-dev nlohmann-json3-dev libstb-dev libeigen3-dev)
test_packages=(clang clang-format clang-tidy llvm-14 libclang-rt-dev libgtest-dev googletest
  libbenchmark-dev librapidcheck-dev emscripten nodejs python3 git ca-certificates admesh chromium)
# googletest: the WebAssembly preset is configured with it, whatever is built then.
studio_packages=(emscripten nodejs googletest)
judge_packages=(assimp-utils blender python3-numpy godot3-server prusa-slicer)

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

# need_node_modules: what apps/web/package-lock.json names, in apps/web/node_modules. No package's own scripts are run.
need_node_modules() {
  local web=$top/apps/web stamp=$top/build/node_modules.lock log=$top/build/node_modules.log
  cmp -s "$web/package-lock.json" "$stamp" && [ -d "$web/node_modules" ] && return
  # npm may come with a nodejs that is not Debian's.
  command -v npm >/dev/null || need_packages npm || return 1
  mkdir -p "$top/build"
  echo "Installing the packages of the studio (npm) ..." >&2
  if ! (cd "$web" && npm ci --ignore-scripts --no-audit --no-fund) >"$log" 2>&1; then
    cat "$log" >&2
    return 1
  fi
  cp "$web/package-lock.json" "$stamp"
}

# Prints a hash of all that the studio's build reads.
studio_inputs() {
  (cd "$top" && find apps/web apps/words.json examples/sketches examples/characters \
    build/wasm/apps/web/core.js build/wasm/apps/web/core.wasm build/release/inkflate \
    \( -name node_modules -o -path apps/web/e2e \) -prune -o -type f -print0 | LC_ALL=C sort -z |
    xargs -0 sha256sum) | sha256sum
}

# build_studio: the web studio in build/studio, from the core as WebAssembly. Silent when there is nothing to do.
build_studio() {
  local web=$top/apps/web stamp=$top/build/studio.inputs log=$top/build/studio.log inputs
  need_packages "${studio_packages[@]}" && need_node_modules || return 1
  build_target wasm studio_core && build_target release inkflate || return 1
  inputs=$(studio_inputs)
  [ "$(cat "$stamp" 2>/dev/null)" = "$inputs" ] && [ -f "$top/build/studio/index.html" ] && return
  rm -f "$stamp"
  echo "Building the studio ..." >&2
  if ! (cd "$web" && npm run --silent build) >"$log" 2>&1; then
    cat "$log" >&2
    return 1
  fi
  echo "$inputs" >"$stamp"
}
