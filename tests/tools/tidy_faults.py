#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Shows files with planted faults to clang-tidy the way tidy.py does, several in one unit: each has to be told, at the
file it is in, and nothing in a clean one. One fault for each group of checks in .clang-tidy and tests/.clang-tidy.
"""
import pathlib
import re
import shutil
import sys

import tidy
from tidy_units import Source, make_units

WORK = tidy.TOP / "build" / "tidy_faults" / "src"  # a path that HeaderFilterRegex takes for ours
FLAGS = ("-std=c++20", "-DINKFLATE_DCHECKS", f"-I{WORK}", f"-I{tidy.TOP}/src")
HEAD = '#include "base/check.h"\n'
HEAD += "#include <string>\n#include <vector>\n\n"

# check -> what follows the HEAD; all in one unit, where Part and helper would collide
FAULTS = {
    "bugprone-assert-side-effect": 'int f(int n) {\n  DCHECK(n++ > 0, "");\n  return n;\n}',
    "bugprone-infinite-loop": "int f(int n) {\n  int i = 0;\n  while (i < n) {\n  }\n  return i;\n}",
    "bugprone-integer-division": "double f(int n) { return n / 2; }",
    "bugprone-suspicious-semicolon": "int f(int n) {\n  if (n > 3);\n  return n;\n}",
    "bugprone-use-after-move": "auto f(std::string s) {\n  auto t = std::move(s);\n  return t + s;\n}",
    "clang-analyzer-core.DivideZero": "int f(int n) {\n  int i = 0;\n  if (n > 3) i = 1;\n  return n / i;\n}",
    "clang-analyzer-core.NullDereference": (
        "namespace {\nstruct Part {\n  int size = 0;\n};\nint helper(Part* part, int n) {\n  if (n > 3) part = nullptr;\n"
        "  return part->size;\n}\n}  // namespace\nint f() {\n  Part part;\n  return helper(&part, 4);\n}"
    ),
    "clang-analyzer-cplusplus.NewDeleteLeaks": "int f(int n) {\n  int* p = new int(n);\n  return *p + 1;\n}",
    "misc-no-recursion": "int f(int n) { return n < 2 ? 1 : n * f(n - 1); }",
    "misc-redundant-expression": "bool f(int n) { return n - 1 == n - 1; }",
    "misc-unused-parameters": "namespace {\nint helper(int n) { return 3; }\n}  // namespace\nint f() { return helper(1); }",
    "misc-unused-using-decls": "namespace other {\nstruct Thing {};\n}  // namespace other\nusing other::Thing;",
    "modernize-use-nullptr": "int* f() { return 0; }",
    "modernize-use-override": "struct A {\n  virtual int g();\n};\nstruct B : A {\n  virtual int g();\n};",
    "modernize-use-using": "typedef int Number;",
    "performance-for-range-copy": (
        "std::size_t f(std::vector<std::string> const& all) {\n  std::size_t sum = 0;\n"
        "  for (auto const one : all) sum += one.size();\n  return sum;\n}"
    ),
    "performance-unnecessary-value-param": "std::size_t f(std::vector<int> const all) { return all.size(); }",
    "readability-container-size-empty": "bool f(std::vector<int> const& all) { return all.size() == 0; }",
    "readability-else-after-return": "int f(int n) {\n  if (n > 3) {\n    return 1;\n  } else {\n    return n;\n  }\n}",
    "readability-function-size": "int f(int n) {\n" + "  n = n * 3 % 17;\n" * 61 + "  return n;\n}",
    "readability-identifier-naming": "namespace {\nstruct small_part {};\n}  // namespace\nsmall_part f();",
    "readability-redundant-string-init": 'std::string f() {\n  std::string s = "";\n  return s;\n}',
    "readability-simplify-boolean-expr": "bool f(int n) {\n  if (n > 3) return true;\n  return false;\n}",
}
FAULTS_IN_TESTS = (
    "bugprone-assert-side-effect",
    "bugprone-infinite-loop",
    "bugprone-suspicious-semicolon",
    "bugprone-use-after-move",
    "misc-unused-parameters",
    "performance-for-range-copy",
    "performance-unnecessary-value-param",
    "readability-function-size",
    "readability-identifier-naming",
)
CLEAN = "namespace {\nstruct Part {\n  int width = 3;\n};\nint helper() { return Part().width; }\n}  // namespace\nint f() { return helper(); }"


def plant(name, text, config=tidy.TOP, flags=FLAGS, includes=()):
    path = WORK / name
    path.write_text(text + "\n", encoding="utf-8")
    return Source(path, flags, config, includes, tidy.digest(name.encode()))


def plant_all():
    """[(source, the check that has to complain, or None)]"""
    # A function of each file's own; elsewhere the compiler would see to it.
    planted = []
    for number, (check, code) in enumerate(FAULTS.items()):
        text = HEAD + re.sub(r"\bf\(", f"f{number}(", code)
        planted.append((plant(f"{check}.cpp", text), check))
        if check in FAULTS_IN_TESTS:
            planted.append((plant(f"test-{check}.cpp", text, config=tidy.TOP / "tests"), check))
    planted.append((plant("clean.cpp", HEAD + CLEAN), None))
    header = plant("planted.h", "#pragma once\ntypedef int Number;").path
    planted.append((plant("header.cpp", '#include "planted.h"\nNumber g();', includes=(header,)), "modernize-use-using"))
    # These two cannot be one text, so the fault in the second is found only when they are taken apart.
    apart = FLAGS + ("-DAPART",)
    planted.append((plant("one.cpp", "struct Same {\n  int a = 0;\n};", flags=apart), None))
    planted.append((plant("other.cpp", "struct Same {\n  int* a = 0;\n};", flags=apart), "modernize-use-nullptr"))
    return planted


def main():
    shutil.rmtree(WORK, ignore_errors=True)
    WORK.mkdir(parents=True)
    tidy.STAMPS = tidy.WORK = WORK.parent / "work"
    planted = plant_all()
    sources = [source for source, _ in planted]
    tidy.copy_configurations(sources)
    found = []
    tidy.look(make_units(sources, processors=1), report=found.append)
    failed = 0
    for source, check in planted:
        places = "planted.h" if source.includes else source.path.name
        checks = {match[1] for text in found if f"/{places}:" in text for match in re.finditer(r"\[([\w.-]+)[],]", text)}
        if (check not in checks) if check else checks:
            print(f"{source.path.name}: found {sorted(checks)}")
            failed += 1
    print(f"{len(planted) - failed} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
