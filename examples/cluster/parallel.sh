#!/bin/sh
# Requests by GNU parallel, on this machine or, with --sshlogin and the like as further arguments, on many.
#   parallel.sh [arguments of parallel] <requests.jsonl >answers.jsonl
# Blocks of whole lines go to the workers and their answers come back in order. A block whose worker dies is given to another, and
# of the dead one nothing is kept; what it wrote into files is known again (--resume).
exec parallel --pipe --keep-order --block 32k --retries 3 "$@" kinegraph batch --resume
