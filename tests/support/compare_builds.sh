#!/bin/sh
# Whether two builds of the program write the same bytes: each command below is run by both, and what they write is compared.
#
#     tests/support/compare_builds.sh BEFORE AFTER [--backend vulkan] [MODEL.glb|PANORAMA.hdr|PANORAMA.exr ...]
#
# BEFORE and AFTER are two `lambent` programs. Models and panoramas that are named are drawn, traced and baked besides what the
# program makes itself. Every command is printed with "same" or "DIFFERENT", and where pictures differ by how much; the exit
# code is 1 if any do. On a device bytes may differ by rounding: there only differences above 0.1 % of the mean count.
set -eu

[ $# -ge 2 ] || { sed -n '2,8s/^# \{0,1\}//p' "$0" >&2; exit 2; }
before=$(realpath "$1")
after=$(realpath "$2")
shift 2
backend=cpu
models=
panoramas=
while [ $# -gt 0 ]; do
    case "$1" in
    --backend) backend=$2; shift ;;
    *.glb | *.gltf) models="$models $(realpath "$1")" ;;
    *) panoramas="$panoramas $(realpath "$1")" ;;
    esac
    shift
done
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
count=0
different=0

# Whether both wrote the same, or on a device near enough; what differs goes to `how`.
same() {
    diff -rq "$folder/a" "$folder/b" >"$folder/how" 2>&1 && return 0
    picture=$(cd "$folder/a" && ls -- *.exr *.hdr *.png *.jpg 2>/dev/null | head -1)
    [ -n "$picture" ] || return 1
    bound=
    [ "$backend" = cpu ] || bound="--max-rel 0.001"
    # shellcheck disable=SC2086
    "$after" compare "$folder/b/$picture" "$folder/a/$picture" $bound >>"$folder/how" 2>&1 && [ -n "$bound" ]
}

# check WORD ...: runs the command by both, each in a folder of its own.
check() {
    count=$((count + 1))
    rm -rf "$folder/a" "$folder/b"
    mkdir "$folder/a" "$folder/b"
    : >"$folder/how"
    a=0
    b=0
    (cd "$folder/a" && "$before" "$@" --quiet) >"$folder/a.out" 2>&1 || a=$?
    (cd "$folder/b" && "$after" "$@" --quiet) >"$folder/b.out" 2>&1 || b=$?
    if [ "$a" = "$b" ] && cmp -s "$folder/a.out" "$folder/b.out" && same; then
        printf 'same       (%s) lambent %s\n' "$a" "$*"
    else
        different=$((different + 1))
        printf 'DIFFERENT  (%s %s) lambent %s\n' "$a" "$b" "$*"
        sed 's/^/           /' "$folder/how" | head -6
    fi
}

# render PICTURE SCENE WORD ...: small, so that all of them take a minute or two.
render() {
    picture=$1
    shift
    check render "$@" --bounces 0 --backend "$backend" --no-cache --size 320x180 -o "$picture"
}

for scene in grid report teapot sphere plane painted furnace; do
    render p.exr "$scene"
    render p.exr "$scene" --model phong
    render p.png "$scene" --env sky --env-rotation 40 --tone agx --dither
done
for env in kitchen studio sky furnace none; do
    render p.exr grid --env "$env" --light directional:30,40,3,3,3 --light point:0,3,1,40,20,10
    render p.exr report --model phong --env "$env" --light directional:30,40,3,3,3 --light point:0,3,1,40,20,10
done
for words in '--ibl split-sum' '--samples 8' '--samples 300' '--aa 1' '--aa 16' '--roughness 0.3' '--roughness 0' \
    '--no-energy-compensation' '--ambient-brightness 2' '--background none' '--background blur:0.5' \
    '--background 0.1,0.2,0.3' '--space nonlinear' '--camera 80,5,3' '--fov 10' '--density 0.3' \
    '--model phong --mip-level report' '--model phong --alpha 40 --kd .2,.3,.4 --ks .5,.5,.5'; do
    # shellcheck disable=SC2086
    render p.exr grid $words
    # shellcheck disable=SC2086
    render p.exr painted --env studio $words
done
render p.png report --model phong --pipeline report
render p.exr grid --pipeline report --model phong --space nonlinear
render p.exr painted --layers layers
render p.exr report --model phong --layers layers
render p.jpg teapot --tone neutral
render p.hdr teapot --tone aces
for panorama in $panoramas; do
    render p.exr grid --env "$panorama"
    render p.exr report --env "$panorama" --model phong --background blur:0.3
    [ "$backend" != cpu ] || check bake "$panorama" --size 64 -o bake
    [ "$backend" != cpu ] || check reference grid --env "$panorama" --size 160x90 --spp 4 -o r.exr
done
for model in $models; do
    render p.exr "$model"
    render p.exr "$model" --model phong --env studio
    render p.exr "$model" --env sky --animation 0 --moment 0.7
    [ "$backend" != cpu ] || check reference "$model" --size 160x90 --spp 4 -o r.exr
done
if [ "$backend" = cpu ]; then
    for scene in grid report teapot painted; do
        check reference "$scene" --size 160x90 --spp 4 -o r.exr
        check reference "$scene" --size 160x90 --spp 4 --model phong --bounces 0 -o r.exr
        check reference "$scene" --size 160x90 --spp 2 --light point:0,3,1,40,20,10 --seed 7 -o r.exr
    done
    for env in kitchen studio sky furnace; do
        check env "$env" --size 256x128 -o e.exr
        check bake "$env" --size 64 -o bake
        check bake "$env" --size 32 --specular phong --roughness cmgen --irradiance sh -o cube.ktx2
        check bake "$env" --size 32 --env-rotation 30 -o cube.dds
    done
fi
printf '%s commands, %s of them different\n' "$count" "$different"
[ "$different" = 0 ]
