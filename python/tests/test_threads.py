"""A thousand random mechanisms in four threads: the values of the program, and memory that does not grow."""

import json
import os
import subprocess
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor

import conftest
import kinegraph
from random_mechanisms import random_mechanism

COUNT = 1000


def outcome(seed: int) -> tuple[str, object]:
    try:
        solution = random_mechanism(seed).solve()
    except kinegraph.Error as error:
        return "refused", [f"{fault}" for fault in str(error).split("\n")]
    return "solved", json.loads(solution.json(exact=True))


def test_values_are_the_programs_in_four_threads(program):
    requests = "".join(json.dumps({"mechanism": json.loads(random_mechanism(seed).text), "exact": True}) + "\n"
                       for seed in range(COUNT))
    answers = [json.loads(line) for line in program("batch", "--jobs", "2", input=requests.encode()).splitlines()]
    with ThreadPoolExecutor(4) as pool:
        ours = list(pool.map(outcome, range(COUNT)))
    assert len(answers) == len(ours) == COUNT
    solved = 0
    for seed, (answer, (kind, found)) in enumerate(zip(answers, ours)):
        if kind == "solved":
            assert found == answer["result"], seed
            solved += 1
        else:
            assert [error.removeprefix("mechanism: ") for error in answer["errors"]] == found, seed
    assert COUNT / 2 < solved < COUNT


def test_other_threads_run_while_one_computes(examples):
    mechanism = kinegraph.load(examples / "watt_six_bar.json")
    done = threading.Event()

    def compute():
        mechanism.sweep(steps=40_000).csv()
        done.set()

    worker = threading.Thread(target=compute)
    worker.start()
    turns = 0
    while not done.is_set():  # with the lock held, this thread would get a turn before and after only
        turns += 1
        time.sleep(0.001)
    worker.join()
    assert turns > 10


GROWTH = """
import os, sys
from concurrent.futures import ThreadPoolExecutor
import kinegraph
from random_mechanisms import random_mechanism

def work(seed):
    try:
        solution = random_mechanism(seed).solve()
        solution.names, solution.statements, solution.svg(figure="velocity")
        random_mechanism(seed).sweep(steps=12)["turn"]
    except kinegraph.Error as error:
        str(error), error.faults

def resident():
    with open("/proc/self/statm") as status:
        return int(status.read().split()[1]) * os.sysconf("SC_PAGE_SIZE") / 2**20

with ThreadPoolExecutor(4) as pool:
    for round in range(6):
        list(pool.map(work, range(250)))
        print(resident())
"""


def test_memory_does_not_grow():
    folders = [str(conftest.BUILD / "python"), str(conftest.ROOT / "python/tests")]
    # One arena of malloc: how four threads share several is chance.
    environment = {**os.environ, "PYTHONPATH": ":".join(folders), "MALLOC_ARENA_MAX": "1"}
    said = subprocess.run([sys.executable, "-c", GROWTH], env=environment, check=True, stdout=subprocess.PIPE,
                          text=True).stdout
    resident = [float(line) for line in said.split()]
    assert len(resident) == 6
    # A thousand solutions more after the first five hundred: a leak of one solution (some 100 kB each) would be 100 MB.
    assert resident[-1] - resident[1] < 4, resident
