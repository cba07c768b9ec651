#!/bin/sh
# Draws the pictures of README.md and docs/gallery.md and makes the live pages: docs/images/make.sh [PROGRAM].
# PROGRAM is build/kinegraph if left out.
# Pictures that came out above 200 KB are named, and the status is 1.
set -eu
cd "$(dirname "$0")/../.."
program=$(realpath "${1:-build/kinegraph}")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# draw NAME EXAMPLE PAGE OPTION…: one page of what an example gives.
draw() {
    name=$1 example=$2 page=$3
    shift 3
    # What is not wholly determined is drawn as far as it goes, with status 3.
    "$program" solve "examples/$example.json" -o "$work/$name.png" "$@" 2>/dev/null || [ $? -eq 3 ]
    if [ "$page" -gt 1 ]; then mv "$work/$name-$page.png" "$work/$name.png"; fi
    mv "$work/$name.png" "docs/images/$name.png"
}

# plot NAME COMMAND OPTION…: the first page of a whole motion, of a cam, or of the catalogue of pairs.
plot() {
    name=$1
    shift
    "$program" "$@" -o "docs/images/$name.png" --dpi 110 2>/dev/null
    rm -f "docs/images/$name"-[0-9]*.png
}

draw four_bar four_bar 1 --dpi 95
draw sluice_gate sluice_gate 1 --dpi 110
draw whitworth whitworth 1 --dpi 92
draw watt_six_bar watt_six_bar 1 --dpi 92 --lang it
draw gas_force gas_force 2 --dpi 110
draw toggle_clamp toggle_clamp 1 --dpi 110
draw double_butterfly double_butterfly 1 --dpi 85
draw cam_flat_follower cam_flat_follower 1 --dpi 110
draw planetary_train planetary_train 1 --dpi 90
draw act_of_motion act_of_motion_general 1 --dpi 110
draw upright quick_return 1 --dpi 95 --orientation portrait --lang it
draw velocity four_bar_weights 1 --dpi 110 --figure velocity
draw body four_bar_weights 1 --dpi 110 --figure body-3
draw contact joint_contact/cam_and_roller 3 --dpi 100
draw equations slider_crank_offset 2 --dpi 110 --with equations
draw virtual_work virtual_work 1 --dpi 110
draw truss truss_simple 1 --dpi 100
draw engine engine_inertia_gas 2 --dpi 100
draw superposition four_bar_weights 3 --dpi 100
draw gerber_beam gerber_beam 1 --dpi 105
draw equilibrium plate_under_forces 1 --dpi 110
draw redundant redundant/beam_on_two_hinges 1 --dpi 100
draw point_motion motion/projectile 1 --dpi 110
draw positions motion/three_positions 1 --dpi 100 --lang it
draw print slider_crank 1 --dpi 100 --theme print
draw dark slider_crank 1 --dpi 100 --theme dark
draw step_1 four_bar 4 --dpi 80 --steps
draw step_2 four_bar 5 --dpi 80 --steps
plot pairs pairs
plot slider_crank_cycle sweep examples/slider_crank.json --plot "s B" --plot "v B" --plot "a B" --poses 8
plot shaper_cycle sweep examples/quick_return.json --trace C --poses 8
plot sluice_gate_travel sweep examples/sluice_gate_travel.json --plot "effort F_G" --trace O --poses 5
plot jansen_cycle sweep examples/jansen_leg.json --trace F --poses 8
plot cam_from_law cam examples/cams/disc_cam.json --at 60°

status=0
docs/make_pages.sh "$program" 2>/dev/null
node docs/images/live.mjs || status=1
for picture in docs/images/*.png; do
    if [ "$(wc -c <"$picture")" -gt 204800 ]; then
        echo "$picture is larger than 200 KB"
        status=1
    fi
done
exit $status
