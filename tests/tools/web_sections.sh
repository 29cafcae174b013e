# SPDX-License-Identifier: Apache-2.0
# The sections of ./test that try the web studio. To be sourced.

# in_web PROGRAM...: one of the programs that npm has installed counts as one test; shows what it says when it fails.
in_web() {
  if (cd apps/web && "node_modules/.bin/$1" "${@:2}") >"$log" 2>&1; then
    count 1 0
  else
    tail -40 "$log"
    count 0 1
  fi
}

web_types_lint_format() {
  need_node_modules || return
  in_web tsc --noEmit
  in_web eslint .
  in_web prettier --check --log-level warn .
}

# A file that cannot even be loaded holds no test that could fail, so it is counted itself.
web_unit_tests() {
  local report=build/vitest.json status counts
  need_node_modules && build_target wasm studio_core || return
  rm -f "$report"
  (cd apps/web && node_modules/.bin/vitest run --reporter=dot --reporter=json --outputFile.json="../../$report") >"$log" 2>&1
  status=$?
  [ $status -eq 0 ] || tail -60 "$log"
  counts=$(node -p "
    const report = JSON.parse(require('fs').readFileSync('$report'));
    const unread = report.testResults.filter((file) => file.status === 'failed' && file.assertionResults.length === 0);
    report.numPassedTests + ' passed, ' + (report.numFailedTests + unread.length) + ' failed'") || return
  echo "$counts" >>"$log"
  count_from_log
  return $status
}

# What each test saw lies in build/e2e/pictures; what is known about those that failed, in build/e2e/failures.
web_browser_tests() {
  local long=() status
  $is_long && long=(--long)
  build_studio || return
  (cd apps/web && node e2e/run.mjs "${long[@]}") >"$log" 2>&1
  status=$?
  [ $status -eq 0 ] && tail -2 "$log" || grep -v ': passed$' "$log" | cat -s
  count_from_log
  return $status
}
