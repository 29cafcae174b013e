# SPDX-License-Identifier: Apache-2.0
# The sections of ./test: each is a function that calls count for what passed and failed. To be sourced.

mkdir -p build
log=build/test.log  # of the running section
total_passed=0
total_failed=0
table=()

count() {
  section_passed=$((section_passed + ${1:-0}))
  section_failed=$((section_failed + ${2:-1}))
}

# section TITLE FUNCTION: runs it. One that fails without having counted a failure counts as one.
section() {
  local title=$1 start=$SECONDS status
  echo
  echo "=== $title"
  section_passed=0
  section_failed=0
  : >"$log"
  "$2"
  status=$?
  [ $status -ne 0 ] && [ $section_failed -eq 0 ] && section_failed=1
  [ $((section_passed + section_failed)) -eq 0 ] && section_passed=1
  total_passed=$((total_passed + section_passed))
  total_failed=$((total_failed + section_failed))
  table+=("$(printf '%-40s %6d passed %4d failed %5d s' "$title" $section_passed $section_failed $((SECONDS - start)))")
  echo "${table[-1]}"
}

# run_gtest COMMAND...: runs a GoogleTest program as a whole and takes over its counts.
run_gtest() {
  local status passed failed
  timeout 900 "$@" --gtest_brief=1 >"$log" 2>&1
  status=$?
  passed=$(sed -n 's/^\[  PASSED  \] \([0-9]*\) test.*/\1/p' "$log" | tail -1)
  failed=$(sed -n 's/^\[  FAILED  \] \([0-9]*\) test.*, listed below:.*/\1/p' "$log" | tail -1)
  [ $status -ne 0 ] && [ "${failed:-0}" -eq 0 ] && failed=1
  [ $status -ne 0 ] && tail -60 "$log"
  count "${passed:-0}" "${failed:-0}"
}

# Takes over the counts of a program whose output lies in the log and ends with "P passed, F failed".
count_from_log() {
  count "$(sed -n 's/^\([0-9]*\) passed, .*/\1/p' "$log")" "$(sed -n 's/.* passed, \([0-9]*\) failed$/\1/p' "$log")"
}

# tracked_files PATTERN...: what git knows; in a tree without git, all that lies there.
tracked_files() {
  git ls-files -- "$@" 2>/dev/null && return
  local pattern
  for pattern in "$@"; do
    find . -path ./build -prune -o -path ./.git -prune -o -type f -name "$pattern" -print
  done
}

# Prints the table and, as the last line, the counts. Exits: 0 when nothing failed.
summary() {
  echo
  echo "=== summary"
  printf '%s\n' "${table[@]}"
  echo "total time $SECONDS s"
  echo "$total_passed passed, $total_failed failed"
  [ "$total_failed" -eq 0 ]
  exit
}
