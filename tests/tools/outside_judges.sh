# SPDX-License-Identifier: Apache-2.0
# The sections of ./test in which programs of others judge the model files that we write. To be sourced after sections.sh.

test_models=build/test_models        # of tests/support: red above, blue below
example_models=build/example_models  # of the example drawings
example_prints=build/example_prints  # of the same, as one shell each

# From the lock file, once.
judges_from_npm() {
  local folder=tests/judges
  [ $folder/node_modules/.package-lock.json -nt $folder/package-lock.json ] && return
  command -v npm >/dev/null || need_packages npm || return
  npm --prefix $folder ci --no-progress >"$log" 2>&1 && touch $folder/node_modules/.package-lock.json
}

packages_of_judges() {
  need_packages "${judge_packages[@]}"
}

make_test_models() {
  rm -rf $test_models
  build_target dev test_models && build/dev/tests/test_models $test_models
}

# make_example_models EXTENSION...: of every example drawing a model in each of these formats.
make_example_models() {
  local drawing extension
  rm -rf $example_models && mkdir -p $example_models
  build_target release inkflate || return
  for drawing in examples/*/*.svg; do
    for extension in "$@"; do
      build/release/inkflate inflate "$drawing" -o "$example_models/$(basename "$drawing" .svg).$extension" || return
    done
  done
}

# make_example_prints EXTENSION...: of every example drawing a print in each of these formats.
make_example_prints() {
  local drawing extension
  rm -rf $example_prints && mkdir -p $example_prints
  build_target release inkflate || return
  for drawing in examples/*/*.svg; do
    for extension in "$@"; do
      build/release/inkflate inflate "$drawing" --print -o "$example_prints/$(basename "$drawing" .svg).$extension" || return
    done
  done
}

# What our own check says of every example.
sound_models() {
  local model
  for model in $example_models/*; do
    case $model in *.mtl | *.png) continue ;; esac
    if build/release/inkflate check "$model" >"$log"; then
      count 1 0
    else
      cat "$log"
      count 0 1
    fi
  done
}

# run_judges PROGRAM ARGUMENT...: one of tests/judges; takes over its counts. When only the judges were asked, all that they say is shown.
run_judges() {
  local expected='^good |^seen '
  $only_judges && expected='^$'
  python3 "tests/judges/$1" "${@:2}" >"$log" 2>&1
  grep -Ev "$expected" "$log"
  count_from_log
}

outside_judges() {
  judges_from_npm && make_test_models && make_example_models glb stl || return
  sound_models
  run_judges judge.py $test_models/*.glb $test_models/*.stl $example_models/*
}

planted_faults() {
  run_judges planted_faults.py $test_models/torus.glb $test_models/torus.stl
}

all_outside_judges() {
  judges_from_npm && make_test_models && make_example_models glb stl obj 3mf || return
  run_judges judge.py --all --red-over-blue $test_models/*.glb $test_models/*.stl $test_models/*.obj $test_models/*.3mf
  run_judges judge.py --all $example_models/*.glb $example_models/*.stl $example_models/*.obj $example_models/*.3mf
}

# Parts of a drawing that touch nothing stay pieces of their own; our own check tells which, and the judges must count the same.
all_judges_of_prints() {
  local print whole=() pieces=()
  make_example_prints stl 3mf || return
  for print in $example_prints/*; do
    if build/release/inkflate check --quiet --print "$print"; then whole+=("$print"); else pieces+=("$print"); fi
  done
  run_judges judge.py --all --print "${whole[@]}"
  [ ${#pieces[@]} -eq 0 ] && return
  echo "in several pieces: ${pieces[*]##*/}"
  build/release/inkflate check --quiet "${pieces[@]}" || count 0 1
  run_judges judge.py --all "${pieces[@]}"
}

all_planted_faults() {
  run_judges planted_faults.py --all $test_models/torus.glb $test_models/torus.stl
}
