#!/bin/sh
# Makes the live pages of docs/gallery.md in docs/live/: docs/make_pages.sh [PROGRAM]. PROGRAM is build/kinegraph if
# left out. They are some 840 kB of generated HTML, so they are not kept in the repository.
set -eu
cd "$(dirname -- "$0")/.."
program=${1:-build/kinegraph}
mkdir -p docs/live
for name in four_bar watt_six_bar cam_roller_follower; do
    "$program" solve "examples/$name.json" -o "docs/live/$name.html"
done
