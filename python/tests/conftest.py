"""Where the package, the program and the examples are."""

import os
import pathlib
import subprocess
import sys

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = pathlib.Path(os.environ.get("KINEGRAPH_BUILD", ROOT / "build"))
sys.path.insert(0, str(BUILD / "python"))


@pytest.fixture(scope="session")
def root() -> pathlib.Path:
    return ROOT


@pytest.fixture(scope="session")
def examples() -> pathlib.Path:
    return ROOT / "examples"


@pytest.fixture(scope="session")
def program():
    """Runs the program and returns its standard output."""

    def run(*arguments, **more) -> bytes:
        return subprocess.run([BUILD / "kinegraph", *map(str, arguments)], check=True, stdout=subprocess.PIPE,
                              **more).stdout

    return run
