#!/bin/sh
# Parts of pictures by engines that people have: Dask, a job array of Slurm. What is not installed is skipped.
# Slurm's daemons are run for the test alone, on this machine, which takes root.
. "$(dirname "$0")/../support/cases.sh"

PYTHONPATH=$root/bindings/python
export PYTHONPATH
PATH=$BUILD_DIR/bin:$PATH

# A scene that reads a file from a folder beside it.
scene_with_include() {
    mkdir -p parts
    echo '#declare Paint = pigment { color rgbf <.8, 1, .9, .9> }' > parts/paint.inc
    cat > scene.pov <<'END'
#include "parts/paint.inc"
camera { location <0, 2, -8> look_at <0, .5, 0> angle 50 }
light_source { <-5, 8, -9> color rgb <1, 1, 1> }
light_source { <6, 4, -3> color rgb <.4, .4, .6> }
sphere { <0, 1 + clock, 0>, 1 pigment { Paint } finish { reflection .1 phong .6 } interior { ior 1.5 } }
sphere { <-2.2, 1, 1>, 1 pigment { color rgb <.9, .3, .2> } finish { ambient .1 reflection .5 } }
sphere { <0, -100, 0>, 100 pigment { color rgb <.7, .7, .7> } finish { ambient .1 diffuse .7 reflection .2 } }
END
}

# ---- Dask ----

need_dask() {
    "$PYTHON" -c 'import distributed' 2> /dev/null || skip "no distributed (PyPI) for $PYTHON"
}

dask_completes_a_picture_though_two_of_four_workers_are_killed() {
    need_dask
    scene_with_include
    expect 0 "$povc" scene.pov 320 240 one.png -q --spp 64
    expect 0 "$PYTHON" "$root/tests/cluster/kill_two.py" "$povc" scene.pov 320 240 out.png --spp 64
    says out "when two of four workers were killed"
    same one.png out.png
    [ "$(echo out.png*)" = out.png ] || fail "left behind: $(echo out.png*)"
}

dask_goes_on_in_rounds() {
    need_dask
    scene_with_include
    expect 0 "$povc" scene.pov 160 120 one.png -q --error .005
    expect 0 "$PYTHON" -m povtrace.cluster scene.pov 160 120 out.png --workers 2 --povc "$povc" --error .005
    says err "joined after round"
    same one.png out.png
}

dask_draws_the_frames_of_an_animation() {
    need_dask
    scene_with_include
    ln -s "$povc" ./own-povc
    expect 0 "$PYTHON" -m povtrace.cluster scene.pov 80 60 out.png --workers 2 --povc ./own-povc --frames 1-3 -q
    expect 0 "$povc" +Iscene.pov +W80 +H60 +Oone.png +KFI1 +KFF3
    for i in 1 2 3; do
        same "one$i.png" "out$i.png"
    done
}

dask_says_what_is_wrong_with_the_scene() {
    need_dask
    echo 'sphere { 0, 1 pigmet { rgb 1 } }' > scene.pov
    expect 1 "$PYTHON" -m povtrace.cluster scene.pov 80 60 out.png --workers 1 --povc "$povc" -q
    says err 'did you mean "pigment"?'
}

# ---- Slurm ----

# A cluster of this machine: two nodes, each with a core. $slurm is its folder, whose name is short: sockets lie there.
start_slurm() {
    for program in slurmctld slurmd munged sbatch; do
        command -v $program > /dev/null || skip "no $program here"
    done
    [ "$(id -u)" -eq 0 ] || skip "Slurm's daemons want root"
    slurm=$(mktemp -d /tmp/slurm.XXXXXX)
    mkdir -p "$slurm/state" "$slurm/spool1" "$slurm/spool2"
    chmod 755 "$slurm" "$PWD"
    dd if=/dev/urandom of="$slurm/key" bs=1024 count=1 2> /dev/null
    chmod 400 "$slurm/key"
    munged --force --foreground --key-file="$slurm/key" --socket="$slurm/munge" --pid-file="$slurm/munge.pid" \
        --log-file="$slurm/munge.log" --seed-file="$slurm/seed" --num-threads=2 2> /dev/null &
    munge=$!
    write_slurm_conf > "$slurm/slurm.conf"
    SLURM_CONF=$slurm/slurm.conf
    export SLURM_CONF
    trap stop_slurm EXIT
    sleep 1
    slurmctld -D -c > "$slurm/ctld.out" 2>&1 &
    controller=$!
    slurmd -D -N node1 > "$slurm/node1.out" 2>&1 &
    node1=$!
    slurmd -D -N node2 > "$slurm/node2.out" 2>&1 &
    node2=$!
    for _ in $(seq 100); do
        [ "$(sinfo -h -o '%T %D' 2> /dev/null)" != "idle 2" ] || return 0
        sleep 0.2
    done
    sinfo
    tail "$slurm"/*.out
    skip "Slurm's daemons do not run here: $(tail -n 1 "$slurm/ctld.out")"
}

stop_slurm() {
    for daemon in $node1 $node2 $controller $munge; do
        kill "$daemon" 2> /dev/null || true
    done
    wait "$node1" "$node2" "$controller" "$munge" 2> /dev/null || true
    rm -rf "${slurm:?}"
}

write_slurm_conf() {
    host=$(hostname -s)
    cat <<END
ClusterName=test
SlurmctldHost=$host
SlurmUser=root
SlurmctldPort=$((20000 + $$ % 10000))
AuthType=auth/munge
AuthInfo=socket=$slurm/munge
CredType=cred/munge
StateSaveLocation=$slurm/state
SlurmdSpoolDir=$slurm/spool%n
SlurmctldPidFile=$slurm/ctld.pid
SlurmdPidFile=$slurm/%n.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SchedulerType=sched/builtin
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SlurmdTimeout=5
ReturnToService=2
JobRequeue=1
MpiDefault=none
NodeName=node1 NodeHostname=$host NodeAddr=127.0.0.1 Port=$((30000 + $$ % 10000)) CPUs=1 State=UNKNOWN
NodeName=node2 NodeHostname=$host NodeAddr=127.0.0.1 Port=$((40000 + $$ % 10000)) CPUs=1 State=UNKNOWN
PartitionName=all Nodes=node1,node2 Default=YES MaxTime=INFINITE State=UP
END
}

slurm_joins_the_parts_of_an_array() {
    start_slurm
    scene_with_include
    expect 0 "$povc" scene.pov 160 120 one.png -q --error .005
    expect 0 timeout 300 sh "$root/docs/examples/slurm.sh" scene.pov 160 120 out.png 6 --error .005
    same one.png out.png
    says err "joined after round"
}

# The daemon of a node and all that it runs end at once, as if its machine lost power.
slurm_completes_a_picture_though_a_node_goes_down() {
    start_slurm
    scene_with_include
    expect 0 "$povc" scene.pov 480 360 one.png -q --spp 64
    timeout 300 sh "$root/docs/examples/slurm.sh" scene.pov 480 360 out.png 12 --spp 64 > joined 2>&1 &
    waiting=$!
    for _ in $(seq 300); do
        [ "$(ls out.png.part-* 2> /dev/null | wc -l)" -lt 2 ] || break
        sleep 0.1
    done
    scontrol update nodename=node2 state=down reason=test
    kill -9 "$node2"
    done_before=$(ls out.png.part-* | wc -l)
    actual=0
    wait "$waiting" || actual=$?
    [ "$actual" -eq 0 ] || fail "slurm.sh ended with $actual: $(cat joined)"
    [ "$done_before" -lt 12 ] || fail "all parts were done before the node went down"
    same one.png out.png
}

for group in ${*:-dask slurm}; do
    run_cases_of "$root/tests/cluster/run.sh" "$group"
done
end_cases
