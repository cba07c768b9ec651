"""The package as it is distributed: types, wheel, tutorial."""

import ast
import shutil
import subprocess
import sys
import zipfile

import conftest
import kinegraph

PYTHON = conftest.ROOT / "python"


def test_types_hold():
    subprocess.run([sys.executable, "-m", "mypy", "--config-file", PYTHON / "tests/mypy.ini", "--cache-dir=/dev/null",
                    "-p", "kinegraph"], check=True, cwd=PYTHON)


def test_the_stub_of_the_module_has_what_the_module_has():
    tree = ast.parse((PYTHON / "kinegraph/_core.pyi").read_text(encoding="utf-8"))
    classes = {each.name: {part.name for part in each.body if isinstance(part, ast.FunctionDef)} - {"__init__"}
               for each in tree.body if isinstance(each, ast.ClassDef)}
    functions = {each.name for each in tree.body if isinstance(each, ast.FunctionDef)}

    def public(names):
        return {name for name in names if not name.startswith("_")}

    core = kinegraph._core
    assert functions | set(classes) | {"languages"} == public(vars(core)) and len(classes) > 10
    for name, members in classes.items():
        assert members == public(vars(getattr(core, name))), name


def test_the_wheel_is_complete(tmp_path):
    (wheel,) = (conftest.BUILD / "python").glob("kinegraph-*.whl")
    with zipfile.ZipFile(wheel) as archive:
        names = archive.namelist()
        archive.extractall(tmp_path)
    assert {"kinegraph/py.typed", "kinegraph/_core.pyi", "kinegraph/_builder.pyi"} <= set(names)
    assert any(name.endswith(".so") for name in names) and not any("__pycache__" in name for name in names)
    said = subprocess.run([sys.executable, "-c", "import kinegraph; print(kinegraph.__file__, kinegraph.__version__)"],
                          check=True, cwd=tmp_path, env={"PYTHONPATH": str(tmp_path)}, stdout=subprocess.PIPE,
                          text=True)
    assert said.stdout.startswith(str(tmp_path)) and said.stdout.split()[1] in wheel.name


def test_importing_loads_neither_numpy_nor_pandas():
    said = subprocess.run([sys.executable, "-c", "import sys, kinegraph; print('numpy' in sys.modules, "
                           "'pandas' in sys.modules)"], check=True, cwd=conftest.BUILD / "python",
                          stdout=subprocess.PIPE, text=True)
    assert said.stdout.split() == ["False", "False"]


def test_the_tutorial_runs(tmp_path):
    shutil.copy(PYTHON / "tutorial/tutorial.ipynb", tmp_path)  # its kernel writes where the notebook is
    environment = {"PYTHONPATH": str(conftest.BUILD / "python"), "PATH": "/usr/bin:/bin", "HOME": str(tmp_path)}
    subprocess.run([sys.executable, "-m", "nbconvert", "--to", "html", "--execute", "tutorial.ipynb"], check=True,
                   env=environment, cwd=tmp_path)
    page = (tmp_path / "tutorial.html").read_text(encoding="utf-8")
    # The sheet, a figure and the sweep; the live page in its frame, the plot of matplotlib, the key as a table.
    assert page.count("data:image/svg+xml") >= 3 and "<iframe" in page and "data:image/png" in page and "<table" in page
    assert {path.name for path in tmp_path.glob("*.pdf")} == {"questions.pdf", "solutions.pdf", "key.pdf"}
