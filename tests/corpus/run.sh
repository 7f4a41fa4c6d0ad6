#!/bin/sh
# The scene language as a whole: probes and samples that were measured on POV-Ray, and what a scene may not reach. The
# probes lie beside the tree, in ../shared or where $POVTRACE_SHARED says.
. "$(dirname "$0")/../support/cases.sh"

here=$root/tests/corpus
shared=${POVTRACE_SHARED:-$root/../shared}
[ -d "$shared" ] || shared=$root/../../shared

every_probe_of_the_language_passes() {
    [ -f "$shared/sdl-probes/run.py" ] || skip "there are no probes in $shared"
    [ -d /usr/share/povray-3.7/include ] || skip "the include files of POV-Ray are not installed"
    "$PYTHON" "$shared/sdl-probes/run.py" "$povc" -v
}

internal_functions_have_the_measured_values() {
    [ -f "$shared/functions/samples.csv" ] || skip "there are no samples in $shared"
    "$PYTHON" "$here/functions.py" "$povc" "$shared/functions/samples.csv"
}

# refused FILE WORDS: the scene is refused with that message.
refused() {
    if "$povc" --check "$1" 2> said; then
        fail "$1 was read"
    fi
    grep -q "$2" said || fail "$1: $(cat said)"
}

a_scene_reads_nothing_outside_of_its_folders() {
    mkdir scenes other
    echo '#declare Secret = 1;' > other/secret.inc
    ln -s ../other/secret.inc scenes/link.inc
    ln -s ../other scenes/folder
    cd scenes
    for name in ../other/secret.inc ../other/secret "$PWD/../other/secret.inc" link.inc folder/secret.inc /etc/passwd \
        ./../other/secret.inc; do
        printf '#include "%s"\nsphere { 0, 1 }\n' "$name" > a.pov
        refused a.pov 'is outside of the folders'
        printf '#fopen F "%s" read\n' "$name" > a.pov
        refused a.pov 'there is no file'
    done
    "$povc" --check -L ../other a.pov 2> said || true
    printf '#include "secret.inc"\nsphere { 0, Secret }\n' > a.pov
    refused a.pov 'there is no file'
    "$povc" --check -q -L ../other a.pov
}

a_scene_writes_only_where_that_was_allowed() {
    mkdir scenes open
    ln -s ../closed.txt open/link.txt
    cat > scenes/a.pov <<'END'
#fopen A "../closed.txt" write #write (A, "x") #fclose A
#fopen B "../open/link.txt" write #write (B, "x") #fclose B
#fopen C "../open/../closed.txt" write #write (C, "x") #fclose C
#fopen D "../open/new.txt" write #write (D, "x") #fclose D
#fopen E "here.txt" write #write (E, "#declare R = 2;") #fclose E
#include "here.txt"
sphere { 0, R }
END
    cd scenes
    "$povc" --check -q a.pov
    [ ! -e ../closed.txt ] && [ ! -e ../open/new.txt ] && [ ! -e here.txt ] || fail "a file was written"
    "$povc" --check -q --allow-write ../open a.pov
    [ ! -e ../closed.txt ] && [ ! -e here.txt ] || fail "a file was written outside"
    [ "$(cat ../open/new.txt)" = x ] || fail "no file was written"
    printf '#fopen A "../open/left.txt" write #write (A, "y")\n' > b.pov
    "$povc" --check -q --allow-write ../open b.pov
    [ "$(cat ../open/left.txt)" = y ] || fail "a file that was not closed is not written"
}

text_of_a_scene_goes_to_standard_error_as_it_is() {
    printf '#debug "a"\n#debug "b\\n"\n#warning "w"\nsphere { 0, 1 }\n' > a.pov
    "$povc" --check a.pov 2> said
    head -n 1 said | grep -qx 'ab' || fail "$(cat said)"
    grep -q 'a.pov:3:1: warning: the scene says: w' said || fail "$(cat said)"
}

an_error_tells_the_files_and_macros_around_it() {
    printf '#macro M()\n  oops\n#end\n' > m.inc
    printf '#include "m.inc"\nsphere { 0, 1 M() }\n' > a.pov
    refused a.pov 'm.inc:2:3: error: unknown word "oops"'
    grep -q 'a.pov:2:15: .*in the macro "M", called here' said || fail "$(cat said)"
}

pictures_are_compared_in_every_way_and_crashes_are_seen() {
    mkdir scenes
    printf 'sphere { <0, 0, 5>, 1 } light_source { -9*z rgb 1 }\n' > scenes/a.pov
    printf 'sphere { <0, 0, 5>, oops }\n' > scenes/b.pov
    expect 0 "$PYTHON" "$here/bits.py" --povc "$povc" --scenes scenes --work work
    says out "2 scenes: 1 drawn, the same in every way; 1 not read; 0 late; 0 failed"
    says work/bits.csv "b.pov,not read"
    printf '#!/bin/sh\nkill -SEGV $$\n' > crashes
    printf '#!/bin/sh\necho "a.c:1:2: runtime error: too large" >&2\n' > reports
    printf '#!/bin/sh\necho $LD_LIBRARY_PATH $* > "$4"\n' > differs
    chmod +x crashes reports differs
    expect 1 "$PYTHON" "$here/bits.py" --povc crashes --scenes scenes --work work --once
    says out "a.pov: ended by SIGSEGV"
    expect 1 "$PYTHON" "$here/bits.py" --povc reports --scenes scenes --work work --once
    says out "a.pov: report: a.c:1:2: runtime error"
    expect 1 "$PYTHON" "$here/bits.py" --povc differs --scenes scenes --work work
    says out "no tree: other bits"
}

run_case every_probe_of_the_language_passes
run_case internal_functions_have_the_measured_values
run_case a_scene_reads_nothing_outside_of_its_folders
run_case a_scene_writes_only_where_that_was_allowed
run_case text_of_a_scene_goes_to_standard_error_as_it_is
run_case an_error_tells_the_files_and_macros_around_it
run_case pictures_are_compared_in_every_way_and_crashes_are_seen
end_cases
