# SPDX-License-Identifier: Apache-2.0
# The sections of ./test in which programs of others judge the model files that we write. To be sourced after sections.sh.

test_models=build/test_models  # of tests/support: red above, blue below

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

# run_judges PROGRAM ARGUMENT...: one of tests/judges; takes over its counts.
run_judges() {
  python3 "tests/judges/$1" "${@:2}" | tee "$log"
  count "$(sed -n 's/^\([0-9]*\) passed, .*/\1/p' "$log")" "$(sed -n 's/.* passed, \([0-9]*\) failed$/\1/p' "$log")"
}

outside_judges() {
  judges_from_npm && make_test_models || return
  run_judges judge.py $test_models/*.glb $test_models/*.stl
}

planted_faults() {
  run_judges planted_faults.py $test_models/torus.glb $test_models/torus.stl
}

all_outside_judges() {
  judges_from_npm && make_test_models || return
  run_judges judge.py --all --red-over-blue $test_models/*.glb $test_models/*.stl $test_models/*.obj $test_models/*.3mf
}

all_planted_faults() {
  run_judges planted_faults.py --all $test_models/torus.glb $test_models/torus.stl
}
