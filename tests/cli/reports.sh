# --stats, --explain, --check, --progress.

reports_of_stats_are_a_name_a_value_and_a_unit_a_line() {
    rich_scene
    expect 0 "$povc" rich.pov 128 96 out.png --spp 2 -t 2 --stats
    if grep -vE '^[a-z_]+: [^ ]+( [A-Za-z_]+)?$' out; then
        fail "these lines are not of the form"
    fi
    for name in parse build trace trace_cpu write; do
        grep -qE "^$name: [0-9]+\.[0-9]+ s\$" out || fail "no $name"
    done
    for name in rays_camera rays_shadow rays_reflected rays_transmitted rays_total culled_light_behind \
        culled_light_idle cut_by_depth cut_by_weight inner_reflections escalated objects plugins threads memory_peak pixels; do
        grep -q "^$name: " out || fail "no $name"
    done
    says out "rays_camera: 24576 rays"
    says out "pixels: 12288 pixels"
    says out "threads: 2"
    says out "objects: 4"
    total=$(awk '/^rays_(camera|shadow|reflected|transmitted):/ { n += $2 } END { print n }' out)
    says out "rays_total: $total rays"
}

reports_of_counts_do_not_depend_on_threads() {
    rich_scene
    expect 0 "$povc" rich.pov 31 23 out.png -t 1 --stats
    grep -E ' rays$' out > one
    expect 0 "$povc" rich.pov 31 23 out.png -t 3 --preview 8 --stats
    grep -E ' rays$' out > three
    same one three
}

# Light that stays within a room and below a sky need not ask them.
reports_of_rays_that_stay_within_count_no_test() {
    cat > within.pov <<'END'
camera { location <0, 3, -4> look_at <0, -1, 0> angle 40 }
light_source { <-5, 8, -9> rgb 1 }
sphere { 0, 1000 hollow pigment { rgb 1 } }
box { -900, 900 hollow pigment { rgb 1 } }
sphere { <.4, -.5, .2>, .3 pigment { rgb 1 } }
plane { y, -1 pigment { rgb 1 } }
END
    expect 0 "$povc" within.pov 40 30 out.png -t 1 --stats
    says out "rays_shadow: 1200 rays"
    says out "box_tested: 0 intersections"
    awk '/^sphere_tested:/ { exit !($2 < 100) }' out || fail "light asks the sky"
}

# Planes and endless quadrics that are finite together have a box; those that are not have none.
reports_count_what_is_infinite() {
    cat > finite.pov <<'END'
camera { location -5*z look_at 0 }
#declare Tube = quadric { <1, 0, 1>, 0, 0, -1 }
intersection { plane { <1, .2, 0>, 1 } plane { <-1, 0, .3>, 1 } plane { y, 1 } plane { -y, 1 } plane { z, 1 } plane { -z, 1 } }
intersection { object { Tube } plane { y, 1 } plane { -y, 1 } rotate 30*x }
intersection { quadric { <1, -1, 1>, 0, 0, 0 } plane { y, 2 } plane { -y, 0 } translate x }
intersection { quadric { <1, 0, 1>, 0, <0, -1, 0>, 0 } plane { y, 2 } }
END
    sed 's/ plane { -y, 1 }//' finite.pov > infinite.pov
    expect 0 "$povc" finite.pov 8 8 out.png --stats
    says out "objects_infinite: 0"
    expect 0 "$povc" infinite.pov 8 8 out.png --stats
    says out "objects_infinite: 2"
}

reports_explain_without_sizes_and_without_rendering() {
    small_scene
    expect 0 "$povc" --explain small.pov
    says out "sphere"
    grep -qE '^\+ ' out
    grep -qE '^- ' out
    [ "$(ls)" = "$(printf 'err\nout\nsmall.pov')" ]
    grep -qE '^\+ plugin sphere +loaded +objects: [0-9]+$' out
    says_not out "plugin png"
    expect 0 "$povc" small.pov 8 8 a.png --explain
    grep -qE '^\+ plugin png +loaded' out
    grep -qE '^\+ ' out
    [ -s a.png ]
    expect 0 "$povc" small.pov 8 8 - --explain
    says err "SUBJECT"
    [ "$(head -c 4 out | tail -c 3)" = PNG ]
}

reports_of_check_need_no_sizes_and_touch_no_output() {
    small_scene
    expect 0 "$povc" --check small.pov
    says out "small.pov: no errors, 0 warnings; 1 object, 1 light, "
    expect 0 "$povc" small.pov 8 8 a.png --check
    [ ! -e a.png ]
    expect 0 "$povc" --check -q small.pov
    [ ! -s out ]
    printf 'sphere {' > wrong.pov
    expect 1 "$povc" --check wrong.pov
}

reports_of_progress_are_json_lines() {
    rich_scene
    "$PYTHON" "$drive" wait:1.5 TERM -- "$povc" rich.pov 640 480 out.png --spp 65536 --progress json > status 2> err
    grep '^{' err > lines
    "$PYTHON" - <<'END'
import json
rows = [json.loads(line) for line in open("lines")]
assert 2 <= len(rows) <= 6, len(rows)
assert all(0 <= a["fraction"] <= b["fraction"] < 1 for a, b in zip(rows, rows[1:]))
assert all(row["percent"] < 100 and row["threads"] >= 1 for row in rows)
END
    expect 0 "$povc" rich.pov 8 8 out.png --progress json
    says err '"percent":100,'
}

reports_of_progress_are_silent_without_a_terminal_and_a_bar_on_one() {
    rich_scene
    expect 0 "$povc" rich.pov 64 48 out.png --spp 64
    [ ! -s err ]
    cat > terminal.py <<'END'
import os, pty, sys
pid, fd = pty.fork()
if pid == 0:
    os.execvp(sys.argv[1], sys.argv[1:])
text = b""
while True:
    try:
        more = os.read(fd, 4096)
    except OSError:
        break
    if not more:
        break
    text += more
os.waitpid(pid, 0)
sys.stdout.buffer.write(text)
END
    TERM=xterm "$PYTHON" terminal.py timeout -s INT 1 "$povc" rich.pov 640 480 out.png --spp 65536 > bar
    says bar "rays/s"
    says_not bar "100 %"
    TERM=xterm "$PYTHON" terminal.py timeout -s INT 1 "$povc" rich.pov 640 480 out.png --spp 65536 -q > quiet
    [ ! -s quiet ]
}

# Filters know where rays go through a flat box, and which plane of an axis comes first is no matter of rounding.
reports_flat_boxes_are_crossed_in_double() {
    cat > flat.pov <<'END'
#version 3.7;
camera { orthographic location <0,0,-1> look_at 0 right x up y }
light_source { <0,0,-5> rgb 1 }
box { <-.4,-.4,0>, <.4,.4,0> pigment { rgb 1 } }
END
    expect 0 "$povc" flat.pov 40 30 o.png --stats
    says out "box_tested: 768 intersections"
    says out "box_escalated: 0 intersections"
}

# Light ends on the surface that its lamp lies in: of other triangles and of edges filters decide.
reports_lamps_in_surfaces_are_told_by_their_distance() {
    cat > lamp.pov <<'END'
#version 3.7;
#default { pigment { rgb 1 } }
camera { location <0, 1, -2> look_at <0, 0, 0> }
light_source { <0.5, 2, 0.25>, 1 }
triangle { <-4, 0, -4>, <4, 0, -4>, <4, 0, 4> }
triangle { <-4, 0, -4>, <-4, 0, 4>, <4, 0, 4> }
triangle { <-4, 2, -4>, <4, 2, -4>, <4, 2, 4> }
triangle { <-4, 2, -4>, <-4, 2, 4>, <4, 2, 4> }
triangle { <-1, 0, -1>, <-1, 3, -1>, <-1, 3, 3> }
triangle { <1, 0, -1>, <1, 3, -1>, <1, 3, 3> }
END
    expect 0 "$povc" lamp.pov 40 30 o.png --stats
    says out "rays_shadow: 1014 rays"
    says out "triangle_escalated: 999 intersections"
}

# Defect 29 of the review.
reports_defect_29_name_what_a_run_is_repeated_with() {
    small_scene
    expect 0 "$povc" small.pov 8 6 o.png --spp 4 --seed 7 --report r.json
    "$PYTHON" - <<'END'
import json, re
r = json.load(open("r.json"))
assert re.fullmatch(r"\d+\.\d+\.\d+", r["version"]), r["version"]
assert re.fullmatch(r"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ", r["date"]), r["date"]
assert r["processor"] and r["seed"] == 7 and r["sampling"] == "auto: uniform", r
assert r["command"] == "povc small.pov 8 6 o.png --spp 4 --seed 7 --report r.json", r["command"]
END
    expect 0 "$povc" small.pov 8 6 "o <1>.png" --error 0.5 --report r.html
    says r.html "How to reproduce"
    says r.html "povc small.pov 8 6 'o &lt;1&gt;.png' --error 0.5 --report r.html"
    expect 0 "$povc" small.pov 8 6 "it's.png" --report r.json
    sh -c "set -- $("$PYTHON" -c 'import json; print(json.load(open("r.json"))["command"])'); printf '%s\\n' \"\$@\"" > words
    says words "it's.png"
    says r.html "seed 0, sampling auto: adaptive"
}

# F6 of the review: a header of 20000 x 20000 and no pixels took 1.2 GB.
reports_f6_refuse_a_reference_by_its_header() {
    small_scene
    "$PYTHON" - <<'END'
import struct, zlib
def chunk(name, data):
    return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))
png = chunk(b"IHDR", struct.pack(">IIBBBBB", 20000, 20000, 8, 2, 0, 0, 0)) + chunk(b"IDAT", zlib.compress(b"")) + chunk(b"IEND", b"")
open("huge.png", "wb").write(b"\x89PNG\r\n\x1a\n" + png)
open("wide.ppm", "wb").write(b"P6 20000 12000 255\n" + bytes(99))
END
    (ulimit -v 400000; expect 1 "$povc" small.pov 8 6 o.png --spp 4 --report r.csv --reference huge.png -t 1)
    (ulimit -v 400000; expect 1 "$povc" small.pov 8 6 o.png --spp 4 --report r.csv --reference wide.ppm -t 1)
}
