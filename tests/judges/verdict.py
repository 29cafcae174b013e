# SPDX-License-Identifier: Apache-2.0
"""What a judge says of a file, and how judges are called."""
import subprocess
from dataclasses import dataclass
from pathlib import Path

HERE = Path(__file__).resolve().parent


@dataclass
class Verdict:
    judge: str
    path: Path
    is_good: bool
    said: str

    def __str__(self):
        return f"{'good' if self.is_good else 'BAD '} {self.judge:14} {self.path.name}: {self.said}"


def run(command, timeout_s=120, **settings):
    """Runs a program to its end, or ends it; gives its exit status (None: it took too long) and all that it printed."""
    words = [str(word) for word in command]
    try:
        done = subprocess.run(words, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=timeout_s,
                              check=False, **settings)
    except subprocess.TimeoutExpired as late:
        return None, (late.stdout or b"").decode(errors="replace")
    return done.returncode, done.stdout.decode(errors="replace")


def compare(expected, found):
    """Whether every expected figure was found, and the figures in words."""
    wrong = [name for name in expected if found.get(name) != expected[name]]
    said = ", ".join(f"{found.get(name)} {name}" for name in expected)
    if wrong:
        said += "; expected " + ", ".join(f"{expected[name]} {name}" for name in wrong)
    return not wrong, said
