#!/bin/bash
# A run and a study on a real Slurm: munge, a controller and a node daemon of this machine, in a folder of
# their own, on free ports, as root and without cgroups. Runs the same locally and compares.
# LIMITGAUGE_SLURM_ONLY=run ends before the study.
#
#   tests/slurm.sh PROGRAM        exit code 77: skipped, because something for it is missing
set -euo pipefail

program=$(realpath "${1:?usage: tests/slurm.sh PROGRAM}")
fixtures=$(realpath "$(dirname "$0")/../fixtures")
PATH=$PATH:/usr/sbin:/sbin

skip() { echo "skipped: $*"; exit 77; }
[ "$(id -u)" = 0 ] || skip "Slurm's daemons are started as root here, and this is $(id -un)"
for needed in munged slurmctld slurmd sbatch squeue scancel scontrol sinfo python3; do
  command -v "$needed" >/dev/null || skip "there is no $needed (Debian: slurm-wlm, munge)"
done

began=$(date +%s%N)
say() { printf '%6.1f s  %s\n' "$(($(date +%s%N) - began))e-9" "$*"; }

folder=$(mktemp -d /tmp/limitgauge-slurm-XXXXXX)
chmod 711 "$folder"
daemons=()
study=
reason=
stop_all() {
  local code=$?
  trap - EXIT INT TERM
  [ -z "$study" ] || kill -KILL "$study" 2>/dev/null || true
  if [ $code -ne 0 ]; then
    tail -n 20 "$folder"/*.log 2>/dev/null || true
  fi
  [ ${#daemons[@]} -lt 2 ] || timeout 10 scancel --user=root 2>/dev/null || true
  # Last started, first stopped; what does not go is killed.
  for ((i = ${#daemons[@]} - 1; i >= 0; --i)); do
    kill "${daemons[i]}" 2>/dev/null || true
    for _ in $(seq 50); do kill -0 "${daemons[i]}" 2>/dev/null || break; sleep 0.1; done
    kill -KILL "${daemons[i]}" 2>/dev/null || true
    wait "${daemons[i]}" 2>/dev/null || true
  done
  rm -rf "$folder"
  # Last, so that it is among what is left of a long log.
  [ -z "$reason" ] || echo "$reason"
  exit $code
}
trap stop_all EXIT
trap 'exit 130' INT TERM
fail() { reason="FAILED: $*"; exit 1; }

# Slurm's commands give up after MessageTimeout; on a busy machine the next try is answered.
asked() { for _ in 1 2 3 4; do "$@" 2>/dev/null && return; sleep 0.5; done; "$@"; }
queue() { asked squeue --noheader "$@"; }
# Tries `$2...` until it holds, for `$1` seconds by the clock: on a busy machine a look takes long too.
within() {
  local last=$((SECONDS + $1))
  shift
  until "$@"; do
    [ $SECONDS -lt $last ] || return 1
    sleep 0.05
  done
}

# ---- a cluster of one node
# Ports below those that the system gives to whoever asks for any (32768 and up): nobody gets them meanwhile.
read -r controller_port node_port < <(python3 - <<'PYTHON'
import random, socket
free = []
while len(free) < 2:
    port = random.randrange(20000, 32000)
    with socket.socket() as s:
        try:
            s.bind(('', port))
        except OSError:
            continue
    if port not in free:
        free.append(port)
print(*free)
PYTHON
)
host=$(hostname -s)
head -c 1024 /dev/urandom > "$folder/munge.key"
chmod 400 "$folder/munge.key"
mkdir "$folder/state" "$folder/spool"
cat > "$folder/slurm.conf" <<CONF
ClusterName=limitgauge
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$controller_port
SlurmdPort=$node_port
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket=$folder/munge.socket
CredType=cred/munge
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
MpiDefault=none
ReturnToService=2
SlurmdTimeout=15
MessageTimeout=5
SlurmdParameters=config_overrides
SchedulerParameters=sched_interval=1,batch_sched_delay=0,bf_interval=1
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.log
MaxArraySize=3
NodeName=$host NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=cases Nodes=ALL Default=YES MaxTime=INFINITE State=UP
CONF
export SLURM_CONF=$folder/slurm.conf
# What a job that we may ourselves be in was given is not for the jobs here.
for name in $(compgen -e | grep -E '^(SLURM_|SBATCH_)' | grep -v '^SLURM_CONF$' || true); do
  unset "$name"
done

munged --foreground --force --socket="$folder/munge.socket" --key-file="$folder/munge.key" \
  --pid-file="$folder/munged.pid" --seed-file="$folder/munge.seed" \
  --log-file="$folder/munged.log" > "$folder/munged.out.log" 2>&1 &
daemons+=($!)
within 60 test -S "$folder/munge.socket" || fail "munge does not start"
slurmctld -D > "$folder/slurmctld.out.log" 2>&1 &
daemons+=($!)
slurmd -D > "$folder/slurmd.out.log" 2>&1 &
daemons+=($!)
is_idle() { [ "$(timeout 10 sinfo --noheader --format=%T 2>/dev/null)" = idle ]; }
within 90 is_idle || fail "the cluster does not come up"
say "$(slurmd -V): $(sinfo --noheader --format='%D node, %c processors, %T')," \
  "arrays of at most $(scontrol show config | awk '/^MaxArraySize/ { print $3 }') tasks"

# ---- one run, its measuring shared out: the same result, byte for byte, but for what is a matter of the run
cd "$folder"
quick=(--set stage.rough.step=0.8 --set stage.finish.gate.uncut=0.2 --set simulation.voxel=0.5
  --set verification.resolution=0.02)
run_job() { "$program" run "$fixtures/jobs/quick-dome.toml" --no-pictures "${quick[@]}" "$@"; }
run_job -o run-local --quiet
run_job -o run-slurm --engine slurm --cache cache-run --jobs 3 > run.txt 2> run.err ||
  fail "the shared run ended with exit code $?: $(cat run.err)"
say "run, shared out: $(tail -n 2 run.txt | head -n 1)"
cat > same.py <<'PYTHON'
import json, pathlib, sys

OF_THE_RUN = {'created', 'threads', 'seconds', 'memory_bytes', 'peak_memory_bytes'}

def without_run(value):
    if isinstance(value, list):
        return [without_run(v) for v in value]
    if isinstance(value, dict):
        return {k: without_run(v) for k, v in value.items() if k not in OF_THE_RUN}
    return value

a, b = (json.dumps(without_run(json.loads((pathlib.Path(f) / 'result.json').read_text())))
        for f in sys.argv[1:])
if a != b:
    sys.exit(f'result.json differs:\n{a}\n{b}')
for field in sorted(pathlib.Path(sys.argv[1]).rglob('deviation.vtp')):
    if field.read_bytes() != (sys.argv[2] / field.relative_to(sys.argv[1])).read_bytes():
        sys.exit(f'{field} differs')
PYTHON
python3 same.py run-local run-slurm || fail "the shared run has other figures"
[ "$(find cache-run/result -type f | wc -l)" = 18 ] ||
  fail "two stages are not 18 pieces: $(find cache-run/result -type f | wc -l)"
[ -z "$(ls cache-run/slurm)" ] || fail "the shared run's work folder was left"

# The first task at work, which is `task` then.
sees_task() {
  task=$(queue --array --states=RUNNING --format=%i | head -n 1)
  [ -n "$task" ]
}
# A node's task is killed at its work, and then the whole run; the next one takes up what is there.
start_run() {
  "$program" run "$fixtures/jobs/quick-dome.toml" --no-pictures "${quick[@]}" -o "$1" \
    --engine slurm --cache "cache-$1" --jobs 3 > "$1.txt" 2> "$1.err" &
  study=$!
  within 60 sees_task || fail "no task was seen at work: $(cat "$1.err")"
}
# One that has ended since it was seen cannot be killed: the next one then.
kills_task() { sees_task && scancel --signal=KILL --full "$task" 2>/dev/null; }
start_run run-killed
within 60 kills_task || fail "no task was killed at its work: $(cat run-killed.err)"
code=0
wait "$study" || code=$?
study=
[ $code = 0 ] || fail "the run that lost a task ended with exit code $code: $(cat run-killed.err)"
python3 same.py run-local run-killed || fail "the run that lost a task has other figures"
say "a task killed: $(grep -c 'ended without an answer' run-killed.err) told of"
start_run run-stopped
kill -TERM "$study"
code=0
wait "$study" || code=$?
study=
[ $code = 4 ] || fail "the interrupted run ended with exit code $code"
[ -z "$(queue --states=PENDING,RUNNING)" ] || fail "jobs of a run were left in the queue"
[ ! -e run-stopped ] || fail "an output folder was left"
code=0
PATH=/nowhere run_job -o no --engine slurm --cache cache-no 2> no.err || code=$?
[ $code = 3 ] || fail "a machine without Slurm ended with exit code $code: $(cat no.err)"
code=0
run_job -o no --engine slurm --cache cache-no --slurm-option=--partition=none 2> no.err || code=$?
[ $code = 4 ] || fail "a refused submission ended with exit code $code: $(cat no.err)"
code=0
run_job -o no --cache cache-no 2> no.err || code=$?
[ $code = 3 ] || fail "--cache without --engine slurm ended with exit code $code: $(cat no.err)"
rm -rf no no.incomplete*
[ "${LIMITGAUGE_SLURM_ONLY:-}" != run ] || { say "all well"; exit 0; }

# ---- a study of six cases, one of which the job refuses
cat > "$folder/study.toml" <<TOML
name = "slurm"
job = "$fixtures/jobs/quick-dome.toml"
[[vary]]
key = "stage.finish.step"
values = [1, 2.4, -1]
[[vary]]
key = "stage.rough.tolerance"
values = [0.05, 0.08]
TOML
cd "$folder"
# Terraces may stand as high as their step, under the 1 mm that roughing may leave.
quick=(--set stage.rough.step=0.8 --set stage.finish.gate.uncut=0.2 --set simulation.voxel=0.5
  --set verification.resolution=0.02)
run_study() { "$program" study study.toml "${quick[@]}" "$@"; }

run_study -o local --cache cache-local > local.txt
say "local: $(head -n 1 local.txt)"

# ---- the same on Slurm, where one task is killed once
"$program" study study.toml "${quick[@]}" -o slurm --cache cache-slurm --engine slurm --jobs 2 \
  > slurm.txt 2> slurm.err &
study=$!
killed=
within 60 kills_task && killed=$task
[ -n "$killed" ] || fail "no task was seen at work: $(cat slurm.err)"
say "killed task $killed"
code=0
wait "$study" || code=$?
study=
cat slurm.err
[ $code = 0 ] || fail "the study ended with exit code $code"
say "slurm: $(head -n 1 slurm.txt)"
grep -q "its Slurm task ${killed} ended without an answer" slurm.err ||
  fail "the killed task is not told of"

# ---- the same results, byte for byte, but for what is a matter of the run
python3 - <<'PYTHON'
import json, pathlib, sys

OF_THE_RUN = {'created', 'threads', 'seconds', 'peak_memory_bytes', 'attempts', 'reused', 'run'}

def without_run(value):
    if isinstance(value, list):
        return [without_run(v) for v in value]
    if isinstance(value, dict):
        return {k: without_run(v) for k, v in value.items() if k not in OF_THE_RUN}
    return value

def files(folder):
    return sorted(str(p.relative_to(folder)) for p in pathlib.Path(folder).rglob('*')
                  if p.is_file())

def content(path):
    if path.suffix == '.json':
        return json.dumps(without_run(json.loads(path.read_text())))
    if path.suffix == '.csv':
        lines = [line.split(',') for line in path.read_text().splitlines()]
        kept = [i for i, name in enumerate(lines[0])
                if name not in OF_THE_RUN]
        return [[line[i] for i in kept if i < len(line)] for line in lines]
    return None

names = files('local')
assert names == files('slurm'), (names, files('slurm'))
assert sum(name.endswith('result.json') for name in names) == 4, names
for name in names:
    a, b = (content(pathlib.Path(folder) / name) for folder in ('local', 'slurm'))
    if a != b:
        sys.exit(f'{name} differs:\n{a}\n{b}')
attempts = [row['attempts'] for row in json.loads(pathlib.Path('slurm/study.json').read_text())['run']['cases']] \
    if 'cases' in json.loads(pathlib.Path('slurm/study.json').read_text()).get('run', {}) else None
print(f'{len(names)} files agree; attempts: {attempts}')
PYTHON
[ ! -d cache-slurm/slurm ] || [ -z "$(ls cache-slurm/slurm)" ] || fail "the work folder was left"

# ---- what was run on Slurm is there for a local run
run_study -o again --cache cache-slurm > again.txt
grep -q "4 reused, 0 run" again.txt || fail "results of Slurm are not reused: $(cat again.txt)"

# ---- a refusal, and a machine without Slurm
code=0
run_study -o no --cache cache-no --engine slurm --slurm-option=--partition=none 2> no.err || code=$?
[ $code = 4 ] || fail "a refused submission ended with exit code $code"
grep -qi partition no.err || fail "the refusal is not told: $(cat no.err)"
code=0
PATH=/nowhere run_study -o no --cache cache-no --engine slurm 2> no.err || code=$?
[ $code = 3 ] || fail "a machine without Slurm ended with exit code $code"
[ ! -e no ] || fail "an output folder was left"

# ---- interrupted: nothing stays in the queue
"$program" study study.toml "${quick[@]}" -o stopped --cache cache-stopped --engine slurm --jobs 1 \
  2> stopped.err &
study=$!
within 60 sees_task || fail "no task was seen at work: $(cat stopped.err)"
kill -TERM "$study"
code=0
wait "$study" || code=$?
study=
[ $code = 4 ] || fail "the interrupted study ended with exit code $code"
[ -z "$(queue --states=PENDING,RUNNING)" ] || fail "jobs were left in the queue"
[ ! -e stopped ] || fail "an output folder was left"
say "interrupted: $(cat stopped.err)"

# ---- killed: its jobs are left, and the next study cancels them; that one meets a partition that is down
start_study() {
  "$program" study study.toml "${quick[@]}" -o "$1" --cache "cache-$1" --engine slurm "${@:2}" \
    2> "$1.err" > "$1.txt" &
  study=$!
  within 60 sees_task || fail "no task was seen at work: $(cat "$1.err")"
}
start_study killed --jobs 1
left=$(queue --format=%j | head -n 1)
kill -KILL "$study"
wait "$study" 2>/dev/null || true
study=
[ -n "$(queue --name="$left")" ] || fail "the killed study has left no job"
scontrol update PartitionName=cases State=DOWN
code=0
run_study -o down --cache cache-killed --engine slurm --slurm-patience 0.05 \
  > down.txt 2> down.err || code=$?
scontrol update PartitionName=cases State=UP
say "down: exit code $code, $(head -n 1 down.err)"
grep -q "jobs $left of a study that was killed were cancelled" down.err ||
  fail "the killed study's jobs are not told of: $(cat down.err)"
[ -z "$(queue --states=PENDING,RUNNING)" ] || fail "jobs were left in the queue"
[ ! -e "cache-killed/slurm/$left" ] || fail "the killed study's folder was left"
grep -q 'has not come back for 0.05 min (pending: PartitionDown)' down/study.csv ||
  fail "the partition is not told of: $(cat down/study.csv)"

# ---- a node that hangs with its tasks
start_study silent --jobs 1 --slurm-patience 0.05
# The node's daemon, and the task at work; the pattern does not match itself.
at_work() { grep -las -- "$folder/[c]ache-silent/slurm/.*tasks" /proc/[0-9]*/cmdline; }
is_at_work() { [ -n "$(at_work)" ]; }
within 60 is_at_work || fail "the task has no process: $(cat silent.err)"
pids=("${daemons[2]}")
for file in $(at_work); do
  file=${file#/proc/}
  pids+=("${file%%/*}")
done
kill -STOP "${pids[@]}"
has_ended() { ! kill -0 "$study" 2>/dev/null; }
within 120 has_ended || fail "a study waits for a node that hangs: $(cat silent.err; squeue; sinfo)"
code=0
wait "$study" || code=$?
study=
kill -CONT "${pids[@]}" 2>/dev/null || true
say "silent: exit code $code, $(head -n 1 silent.err)"
[ $code = 4 ] || fail "the study that lost its node ended with exit code $code: $(cat silent.err)"
grep -q "RUNNING on node $host, which is .*" silent/study.csv ||
  fail "the node is not told of: $(cat silent/study.csv)"
say "all well"
