# The same picture, however it is made.

pictures_do_not_depend_on_threads_preview_or_tree() {
    rich_scene
    expect 0 "$povc" rich.pov 61 47 one.pfm -t 1
    for options in '-t 2' '-t 3' '-t 8' '--preview 16' '--preview 2 -t 3' '--preview 4' '--preview 8 -t 1' '--accel none' \
        '--accel none --preview 16 -t 3'; do
        # shellcheck disable=SC2086
        expect 0 "$povc" rich.pov 61 47 other.pfm $options
        same one.pfm other.pfm
    done
}

pictures_of_many_samples_do_not_depend_on_threads_or_preview() {
    rich_scene
    expect 0 "$povc" rich.pov 31 23 one.pfm -t 1 --spp 5
    expect 0 "$povc" rich.pov 31 23 other.pfm -t 3 --spp 5 --preview 8 --accel none
    same one.pfm other.pfm
    expect 0 "$povc" rich.pov 31 23 single.pfm
    if cmp -s one.pfm single.pfm; then
        fail "five samples are as one"
    fi
}

pictures_of_a_crop_are_that_part_of_the_whole() {
    rich_scene
    expect 0 "$povc" rich.pov 61 47 whole.pfm
    for crop in 0,0,61,47 10,5,40,33 60,46,61,47 0,20,61,21 17,0,18,47; do
        for options in '' '--preview 16 -t 3'; do
            # shellcheck disable=SC2086
            expect 0 "$povc" rich.pov 61 47 part.pfm --crop "$crop" $options
            # shellcheck disable=SC2046
            "$PYTHON" "$pixels" part whole.pfm $(echo "$crop" | tr , ' ') part.pfm
        done
    done
}

pictures_may_be_one_pixel_or_one_row() {
    rich_scene
    for size in '1 1' '1 40' '40 1'; do
        # shellcheck disable=SC2086
        expect 0 "$povc" rich.pov $size out.ppm --preview 16
        [ "$("$PYTHON" "$pixels" size out.ppm)" = "$size 8" ]
    done
}

pictures_cut_at_depth_1_have_no_mirrors() {
    rich_scene
    expect 0 "$povc" rich.pov 31 23 deep.pfm --stats
    [ "$(sed -n 's/^rays_reflected: \([0-9]*\) rays/\1/p' out)" -gt 0 ]
    expect 0 "$povc" rich.pov 31 23 flat.pfm --max-depth 1 --stats
    says out "rays_reflected: 0 rays"
    [ "$(sed -n 's/^cut_by_depth: \([0-9]*\) rays/\1/p' out)" -gt 0 ]
}

pictures_too_large_for_memory_are_an_error() {
    small_scene
    # The sanitizers would rather end the program than let it handle this.
    ASAN_OPTIONS=allocator_may_return_null=1 TSAN_OPTIONS=allocator_may_return_null=1 \
        expect 1 "$povc" small.pov 1000000 1000000 out.png
    says err "memory"
    [ ! -e out.png ]
}

# A small picture costs no more than its start: what is touched is counted, since times depend on the machine
# (make bench-whole has them). A table of 2 MB filled at the start would be seen here.
pictures_of_16_by_16_touch_less_than_512_pages() {
    [ -z "${POVTRACE_SLOW-}" ] || skip "this build is instrumented"
    nm "$BUILD_DIR/bin/povc" | grep -qE '__(asan|tsan|ubsan)' && skip "this build is instrumented"
    small_scene
    "$PYTHON" - "$povc" <<'END'
import os, sys
run = [sys.argv[1], "small.pov", "16", "16", "out.png", "--quiet", "--threads", "1"]
_, status, used = os.wait4(os.posix_spawn(run[0], run, os.environ), 0)
print("%d pages" % used.ru_minflt)
assert status == 0 and used.ru_minflt < 512
END
}

pictures_of_two_parts_throughout_are_the_same_but_for_roundings() {
    rich_scene
    expect 0 "$povc" rich.pov 61 47 certified.pfm --stats
    [ "$(sed -n 's/^escalated: \([0-9]*\) intersections/\1/p' out)" -lt 3000 ]
    expect 0 "$povc" rich.pov 61 47 max.pfm --accuracy max --stats
    [ "$(sed -n 's/^escalated: \([0-9]*\) intersections/\1/p' out)" -gt 3000 ]
    "$PYTHON" "$pixels" near certified.pfm max.pfm 1e-4 2
}

pictures_say_of_each_primitive_what_was_tested_and_escalated() {
    for accuracy in certified max; do
        expect 0 "$povc" "$root/scenes/gallery/machine.pov" 40 30 out.pfm --accuracy "$accuracy" --stats
        awk '/_tested:/ { tested = $2; classes++ } /[a-z]_escalated:/ { if ($2 > tested) exit 1; sum += $2; all += tested }
            /^escalated:/ { escalated = $2 } /^rays_camera:/ { rays = $2 }
            END { exit !(classes == 5 && sum == escalated && all > rays / 2) }' out
    done
    [ "$(sed -n 's/^sphere_tested: //p' out)" = "$(sed -n 's/^sphere_escalated: //p' out)" ]
}

pictures_come_with_maps_of_what_is_met() {
    rich_scene
    expect 0 "$povc" rich.pov 61 47 out.pfm -t 3 --aov certainty c.pfm --aov depth d.pfm --aov normal n.png
    expect 0 "$povc" rich.pov 61 47 out.pfm -t 1 --aov depth other.pfm
    same d.pfm other.pfm
    # The large sphere fills the picture's lower edge; the eye is some 8 away from the row of spheres.
    "$PYTHON" "$pixels" between d.pfm 30 46 4 4.5
    "$PYTHON" "$pixels" between d.pfm 30 24 6 9
    "$PYTHON" "$pixels" between d.pfm 30 0 0 0
    expect 0 "$povc" rich.pov 61 47 out.pfm --aov position p.pfm --aov albedo b.pfm --aov alpha a.pfm
    "$PYTHON" "$pixels" between p.pfm 30 46 -4.4 0.1
    "$PYTHON" "$pixels" between b.pfm 30 46 0.69 0.71
    "$PYTHON" "$pixels" between a.pfm 30 46 1 1
    expect 0 "$povc" rich.pov 61 47 out.pfm --accuracy max --aov certainty m.pfm
    [ "$("$PYTHON" "$pixels" mean c.pfm)" != "$("$PYTHON" "$pixels" mean m.pfm)" ]
    expect 2 "$povc" rich.pov 61 47 out.pfm --aov depth d.nosuch
}

pictures_hold_maps_as_layers() {
    rich_scene
    expect 2 "$povc" rich.pov 61 47 all.png --aov depth all.png
    says err "same file"
    "$povc" rich.pov 9 9 all.exr 2> err || skip "no OpenEXR"
    expect 0 "$povc" rich.pov 61 47 out.pfm --aov depth d.pfm --aov object o.pfm --aov position p.pfm --aov albedo b.pfm
    expect 0 "$povc" rich.pov 61 47 all.exr --aov depth all.exr --aov object all.exr --aov position all.exr --aov albedo all.exr \
        --aov normal all.exr --aov alpha all.exr --aov certainty all.exr --aov time all.exr
    "$PYTHON" -m venv env > log 2>&1 || skip "no venv for $PYTHON"
    env/bin/pip install -q numpy OpenEXR > log 2>&1 || skip "PyPI is not reached"
    env/bin/python "$root/tests/cli/layers.py" all.exr R=out.pfm G=out.pfm B=out.pfm depth.Z=d.pfm object.id=o.pfm \
        position.X=p.pfm position.Y=p.pfm position.Z=p.pfm albedo.R=b.pfm albedo.G=b.pfm albedo.B=b.pfm
}

# Cells of 4 by 4 pixels, alike within; together not more than the threads' time, and most of it.
pictures_come_with_a_map_of_the_time_they_took() {
    rich_scene
    expect 0 "$povc" rich.pov 61 47 plain.pfm --spp 16
    expect 0 "$povc" rich.pov 61 47 out.pfm --spp 16 --aov time t.pfm --aov depth d.pfm --report r.json
    same plain.pfm out.pfm
    "$PYTHON" -c 'import json, struct
data = open("t.pfm", "rb").read()[-61 * 47 * 12:]
rows = [[struct.unpack_from("=3f", data, 12 * (61 * (46 - y) + x)) for x in range(61)] for y in range(47)]
assert all(p[0] == p[1] == p[2] == rows[y & ~3][x & ~3][0] > 0 for y, r in enumerate(rows) for x, p in enumerate(r))
cpu = json.load(open("r.json"))["passes"][-1]["cpu_s"]
assert 0.5 * cpu < sum(p[0] for r in rows for p in r) * 1e-6 <= cpu'
    expect 0 "$povc" rich.pov 61 47 out.pfm --aov time t.ppm
    "$PYTHON" -c 'data = open("t.ppm", "rb").read()[-61 * 47 * 3:]
assert max(data) == 255 and 0 < min(data) < 255'
    expect 0 "$povc" rich.pov 61 47 out.pfm --crop 3,5,33,40 --aov time t.pfm
    [ "$("$PYTHON" "$pixels" size t.pfm)" = "$("$PYTHON" "$pixels" size out.pfm)" ]
}
