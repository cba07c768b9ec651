"""The program, run in a folder of its own."""
from __future__ import annotations

import subprocess
from pathlib import Path

import pytest

TOP = Path(__file__).resolve().parents[2]
PROGRAM = TOP / "build" / "kinegraph"


class Folder:
    def __init__(self, path: Path) -> None:
        self.path = path

    def kinegraph(self, command: str, example: str, *options: str, status: int = 0,
                  env: dict[str, str] | None = None) -> str:
        """Runs the program; returns what it says on standard error."""
        done = subprocess.run([PROGRAM, command, TOP / "examples" / f"{example}.json", *options], cwd=self.path,
                              env=env, capture_output=True, text=True, check=False)
        assert done.returncode == status, done.stderr
        return done.stderr

    def run(self, *words: str) -> str:
        done = subprocess.run(words, cwd=self.path, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stdout[-2000:] + done.stderr[-2000:]
        return done.stdout

    def files(self, pattern: str) -> list[Path]:
        """In the order of their pages."""
        found = sorted(self.path.glob(pattern), key=lambda path: (len(path.name), path.name))
        assert found, pattern
        return found


@pytest.fixture
def folder(tmp_path: Path) -> Folder:
    return Folder(tmp_path)
