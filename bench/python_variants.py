"""bench/python_variants.py [BUILD]: a hundred variants solved from Python in one thread, and the same by `kinegraph
batch --jobs 1`: results as JSON, and A4 sheets as SVG. Prints medians of processor time, and their quotient."""

import itertools
import json
import pathlib
import resource
import statistics
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[1]
BUILD = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ROOT / "build")
sys.path.insert(0, str(BUILD / "python"))
import kinegraph  # noqa: E402: from the build

COUNT, RUNS = 100, 9
exercise = kinegraph.load(ROOT / "examples/variants/four_bar.json")
files = [variant.text for variant in itertools.islice(exercise.variants(seed=7), COUNT)]


def by_batch(want: str, folder: str) -> float:
    lines = "".join(json.dumps({"mechanism": json.loads(text), "want": [want],
                                **({"to": f"{folder}/{number}"} if want == "svg" else {})}) + "\n"
                    for number, text in enumerate(files))
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    answers = subprocess.run([BUILD / "kinegraph", "batch", "--jobs", "1"], input=lines.encode(), check=True,
                             stdout=subprocess.PIPE).stdout.splitlines()
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    assert len(answers) == COUNT and all(json.loads(answer)["status"] == 0 for answer in answers)
    return after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime


def by_python(want: str, folder: str) -> float:
    before = time.process_time()
    for number, text in enumerate(files):
        solution = kinegraph.parse(text).solve()
        if want == "svg":
            solution.save(f"{folder}/{number}.svg")
        else:
            solution.json()
    return time.process_time() - before


for want, what in (("json", "results"), ("svg", "sheets")):
    with tempfile.TemporaryDirectory() as folder:
        # In turn, so that both meet the same machine.
        pairs = [(by_batch(want, folder), by_python(want, folder)) for _ in range(RUNS)]
    batch, python = (statistics.median(each) for each in zip(*pairs))
    print(f"{COUNT} variants, {what}: batch {batch * 1000:.0f} ms, Python {python * 1000:.0f} ms, "
          f"{statistics.median(p / b for b, p in pairs):.2f}")
