# Files: whole or the old one, pipes, formats.

output_formats_follow_from_the_ending() {
    small_scene
    expect 0 "$povc" small.pov 9 7 a.png
    [ "$("$PYTHON" "$pixels" size a.png)" = "9 7 8" ]
    expect 0 "$povc" small.pov 9 7 a.PPM
    [ "$("$PYTHON" "$pixels" size a.PPM)" = "9 7 8" ]
    expect 0 "$povc" small.pov 9 7 a.pfm
    [ "$("$PYTHON" "$pixels" size a.pfm)" = "9 7 32" ]
    "$PYTHON" "$pixels" same a.png a.PPM
    expect 0 "$povc" small.pov 9 7 b.image --format ppm
    same a.PPM b.image
    [ ! -s out ]
    [ ! -s err ]
}

output_of_16_bits_holds_the_same_in_png_and_ppm() {
    rich_scene
    expect 0 "$povc" rich.pov 40 30 a.png --bits 16
    expect 0 "$povc" rich.pov 40 30 a.ppm --bits 16
    [ "$("$PYTHON" "$pixels" size a.png)" = "40 30 16" ]
    "$PYTHON" "$pixels" same a.png a.ppm
}

output_says_srgb_only_of_encoded_values() {
    small_scene
    expect 0 "$povc" small.pov 9 7 linear.png --transfer linear --bits 16
    expect 0 "$povc" small.pov 9 7 srgb.png --transfer srgb --bits 16
    [ "$("$PYTHON" "$pixels" chunks linear.png)" = "IHDR IDAT IEND" ]
    [ "$("$PYTHON" "$pixels" chunks srgb.png)" = "IHDR sRGB IDAT IEND" ]
    if "$PYTHON" "$pixels" same linear.png srgb.png; then
        fail "the curve changed nothing"
    fi
    expect 0 "$povc" small.pov 9 7 linear.pfm --transfer linear
    expect 0 "$povc" small.pov 9 7 srgb.pfm --transfer srgb
    same linear.pfm srgb.pfm
}

output_and_input_may_be_pipes() {
    small_scene
    expect 0 "$povc" small.pov 9 7 file.png
    cat small.pov | "$povc" - 9 7 - 2> err | cat > pipe.png
    [ ! -s err ]
    same file.png pipe.png
    expect 0 "$povc" small.pov 9 7 file.pfm
    "$povc" - 9 7 - --format pfm --stats < small.pov > pipe.pfm 2> err
    same file.pfm pipe.pfm
    says err "rays_total:"
}

output_to_a_device_or_pipe_by_name_goes_there() {
    small_scene
    expect 0 "$povc" small.pov 9 7 file.ppm
    mkfifo pipe.ppm
    cat pipe.ppm > from_pipe &
    expect 0 "$povc" small.pov 9 7 pipe.ppm
    wait $!
    same file.ppm from_pipe
    [ -p pipe.ppm ]
    expect 0 "$povc" small.pov 9 7 /dev/null --format png
}

# F16 of the review: no fsync before rename. The bytes are on the disk before the name is.
output_f16_is_on_the_disk_before_its_name_is() {
    small_scene
    strace -f -o calls true 2> err || skip "strace cannot trace here"
    expect 0 strace -f -y -e trace=fsync,rename,renameat,renameat2 -o calls "$povc" small.pov 9 7 out.png
    order=$(sed -n -e 's/.*fsync([0-9]*<.*\.part>).*= 0/file/p' -e 's/.*rename[a-z0-9]*(.*out\.png".*= 0/name/p' calls | tr '\n' ' ')
    [ "$order" = "file name " ] || fail "$order: $(cat calls)"
}

output_stays_whole_on_a_full_disk() {
    small_scene
    expect 0 "$povc" small.pov 64 64 out.pfm
    cp out.pfm old.pfm
    # A limit on file sizes fails as a full disk does, in the middle of writing.
    expect 1 sh -c 'trap "" XFSZ; ulimit -f 8; exec "$@"' sh "$povc" small.pov 64 64 out.pfm --spp 4
    says err "out.pfm: error: cannot write"
    same out.pfm old.pfm
    [ "$(ls)" = "$(printf 'err\nold.pfm\nout\nout.pfm\nsmall.pov')" ] || fail "something was left: $(ls)"
    if [ -w /dev/full ]; then
        expect 1 "$povc" small.pov 64 64 /dev/full --format ppm
        says err "No space left"
    fi
}

output_stays_whole_on_a_real_full_disk() {
    small_scene
    mkdir disk
    mount -t tmpfs -o size=64k none disk 2> /dev/null || skip "mounting needs root"
    (
        expect 0 "$povc" small.pov 40 40 disk/out.pfm
        cp disk/out.pfm old.pfm
        dd if=/dev/zero of=disk/fill bs=1024 count=64 2> /dev/null || true
        expect 1 "$povc" small.pov 40 40 disk/out.pfm --spp 4
        says err "No space left"
        same disk/out.pfm old.pfm
        [ "$(ls disk)" = "$(printf 'fill\nout.pfm')" ]
    ) && whole=0 || whole=1
    umount disk
    [ "$whole" -eq 0 ]
}

output_stays_whole_when_killed_while_writing() {
    small_scene
    expect 0 "$povc" small.pov 64 64 out.pfm
    cp out.pfm old.pfm
    # SIGXFSZ ends the program in the middle of a write, with no chance to tidy up.
    status=0
    sh -c 'ulimit -c 0; ulimit -f 8; exec "$@"' sh "$povc" small.pov 64 64 out.pfm --spp 4 || status=$?
    [ "$status" -gt 128 ] || fail "it was not killed: $status"
    same out.pfm old.pfm
}

output_stays_whole_when_killed_at_any_moment() {
    rich_scene
    expect 0 "$povc" rich.pov 200 150 new.png
    for delay in 0.005 0.01 0.02 0.03 0.05 0.08; do
        echo old > out.png
        "$PYTHON" "$drive" "wait:$delay" KILL -- "$povc" rich.pov 200 150 out.png > status
        [ "$(cat out.png | head -c 3)" = old ] || same out.png new.png
    done
}

output_keeps_the_permissions_of_the_file_it_replaces() {
    small_scene
    expect 0 "$povc" small.pov 4 4 out.png
    chmod 640 out.png
    expect 0 "$povc" small.pov 4 4 out.png
    [ "$(ls -l out.png | cut -c 1-10)" = "-rw-r-----" ]
}

# F1 of the review: a link stays, and what it points to is replaced.
output_f1_and_defect_22_follows_symbolic_links() {
    small_scene
    mkdir far
    echo old > far/target.ppm
    ln -s far/target.ppm link.ppm
    ln -s link.ppm second.ppm
    ln -s far/new.ppm dangling.ppm
    expect 0 "$povc" small.pov 9 7 plain.ppm
    expect 0 "$povc" small.pov 9 7 second.ppm
    [ -L second.ppm ] && [ -L link.ppm ]
    same far/target.ppm plain.ppm
    expect 0 "$povc" small.pov 9 7 dangling.ppm
    [ -L dangling.ppm ]
    same far/new.ppm plain.ppm
    ln -s loop.ppm loop.ppm
    expect 1 "$povc" small.pov 9 7 loop.ppm
    says err "cannot write"
}

# F1: as root the whole system's /dev/stdout was replaced by a picture.
output_f1_to_what_stands_for_a_descriptor_goes_there() {
    small_scene
    expect 0 "$povc" small.pov 9 7 plain.ppm
    before=$(ls -l /dev/stdout)
    "$povc" small.pov 9 7 /dev/stdout --format ppm > redirected.ppm 2> err
    same plain.ppm redirected.ppm
    [ "$(ls -l /dev/stdout)" = "$before" ]
    "$povc" small.pov 9 7 /dev/fd/5 --format ppm 5> five.ppm 2> err
    same plain.ppm five.ppm
    "$povc" small.pov 9 7 /dev/stdout --format ppm 2> err | cat > piped.ppm
    same plain.ppm piped.ppm
}

# F1: checkpoints too.
output_f1_checkpoints_follow_links() {
    small_scene
    echo precious > precious
    ln -s precious out.pfm.checkpoint
    expect 1 "$povc" small.pov 9 7 out.pfm --resume
    [ "$(cat precious)" = precious ]
    [ -L out.pfm.checkpoint ]
}

# F4: the only signal is often the last one.
output_f4_to_a_pipe_that_nobody_reads_ends_with_one_signal() {
    small_scene
    mkfifo pipe.ppm
    expect 143 timeout -k 20 --preserve-status 1 "$povc" small.pov 9 7 pipe.ppm
}

# F7: the name is tried before the work begins.
output_f7_names_of_any_length_that_the_folder_takes_are_written() {
    small_scene
    long=$(printf 'a%.0s' $(seq 1 251)).ppm
    expect 0 "$povc" small.pov 9 7 "$long"
    [ -s "$long" ]
    expect 1 "$povc" small.pov 900 700 "a$long" --stats
    says err "File name too long"
    [ ! -s out ] || fail "it was rendered first"
    expect 1 "$povc" small.pov 9 7 nowhere/out.ppm
    says err "nowhere/out.ppm: error: cannot write"
}

# F14 of the review, defect 2 of users.md.
output_f14_and_defect_2_names_must_differ() {
    small_scene
    cp small.pov scene.ppm
    expect 2 "$povc" small.pov 9 7 o.png --report o.png
    says err "the picture and --report are the same file"
    expect 2 "$povc" small.pov 9 7 o.png --aov depth ./o.png
    says err "the picture and --aov depth are the same file"
    expect 2 "$povc" scene.ppm 9 7 scene.ppm
    says err "the scene and the picture are the same file"
    cmp scene.ppm small.pov
    [ ! -e o.png ]
    expect 0 "$povc" small.pov 9 7 /dev/null --format png --aov depth o.pfm
}

# F15: what killed processes have left is removed by the next one that writes there, when it is old.
output_f15_sweeps_what_dead_processes_left() {
    small_scene
    sleep 0 & dead=$!
    wait "$dead"
    touch -d '2 hours ago' "o.png.$dead-0.part" "o.png.$$-0.part" "p.png.$dead-0.part"
    touch "o.png.$dead-1.part"
    expect 0 "$povc" small.pov 9 7 o.png
    [ ! -e "o.png.$dead-0.part" ]
    [ -e "o.png.$dead-1.part" ] && [ -e "o.png.$$-0.part" ] && [ -e "p.png.$dead-0.part" ]
}

output_grows_in_tev() {
    rich_scene
    expect 0 "$povc" rich.pov 75 50 one.pfm -q --spp 6
    "$PYTHON" "$root/tests/cli/tev.py" port out.pfm one.pfm > seen 2>&1 &
    viewer=$!
    for _ in $(seq 100); do [ -e port ] || sleep 0.1; done
    expect 0 "$povc" rich.pov 75 50 out.pfm -q --spp 6 --tev "127.0.0.1:$(cat port)"
    wait "$viewer" || fail "$(cat seen)"
    says seen packets
    same one.pfm out.pfm
}

output_does_without_a_viewer_that_is_gone() {
    rich_scene
    "$PYTHON" "$root/tests/cli/tev.py" port out.pfm one.pfm 2 > seen 2>&1 &
    for _ in $(seq 100); do [ -e port ] || sleep 0.1; done
    expect 0 "$povc" rich.pov 320 240 out.pfm --spp 16 --tev "127.0.0.1:$(cat port)"
    says err "the viewer is gone"
    [ -s out.pfm ] || fail "there is no picture"
    expect 1 "$povc" rich.pov 75 50 out.png --tev "127.0.0.1:$(cat port)"
    says err "no viewer answers there"
    expect 2 "$povc" rich.pov 75 50 out.png --tev localhost
}
