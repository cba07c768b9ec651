#!/usr/bin/python3
"""Requests by Dask, on workers of this machine or on those of a scheduler that runs already.

    dask_batch.py [SCHEDULER_ADDRESS] <requests.jsonl >answers.jsonl

Blocks of whole lines go to the workers and their answers come back in order. The block of a worker that dies is given to
another one; what was written into files is known again (--resume).
"""
import subprocess
import sys

from distributed import Client

LINES_OF_A_BLOCK = 500


def answers(block):
    return subprocess.run(["kinegraph", "batch", "--resume"], input=block, stdout=subprocess.PIPE, check=True).stdout


def main():
    lines = sys.stdin.buffer.readlines()
    blocks = [b"".join(lines[i:i + LINES_OF_A_BLOCK]) for i in range(0, len(lines), LINES_OF_A_BLOCK)]
    with Client(*sys.argv[1:]) if sys.argv[1:] else Client(threads_per_worker=1, dashboard_address=None) as client:
        for future in client.map(answers, blocks, retries=3, pure=False):
            sys.stdout.buffer.write(future.result())


if __name__ == "__main__":
    main()
