#!/usr/bin/env bash
# Kills a run and its workers with kill -9 at random moments, resumes it each time, and compares what is left at the
# end with an undisturbed run: the same bits, no case lost, none twice.
#
# tests/chaos.sh PROGRAM [CASES] [KILLS]      default 200 cases, 20 kills; exit code 0 when both are the same
set -euo pipefail

program=$1
cases=${2:-200}
kills=${3:-20}
here=$(cd "$(dirname "$0")" && pwd)
folder=$(mktemp -d)
runner=
trap '[[ -z $runner ]] || kill -9 "$runner" 2> /dev/null || true; rm -rf "$folder"' EXIT
RANDOM=2009

cat > "$folder/sweep.toml" << END
name = "chaos"
strategies = ["nearest-face", "fuzzy-per-vertex"]
organs = ["sphere@6mm"]
tools = ["prism-6"]
scenes = ["penetration"]
speeds = [100, 400]
seeds = $((cases / 4))
END
arguments=("$folder/sweep.toml" --jobs 2 --metrics fast)

started=$(date +%s%N)
"$program" run "${arguments[@]}" -o "$folder/undisturbed.h5" > "$folder/undisturbed.log" 2>&1
milliseconds=$((($(date +%s%N) - started) / 1000000))

start_runner() {
    "$program" run "${arguments[@]}" -o "$folder/chaos.h5" >> "$folder/chaos.log" 2>&1 &
    runner=$!
}

running() { kill -0 "$runner" 2> /dev/null; }

# Moments are spread over the time that an undisturbed run takes, so that most kills meet one at work.
runner_kills=0 worker_kills=0 resumes=0
start_runner
for ((k = 0; k < kills; ++k)); do
    sleep "$(awk -v most=$((milliseconds / kills)) -v draw=$RANDOM 'BEGIN { print most * draw / 32768 / 1000 }')"
    mapfile -t workers < <(pgrep -P "$runner" || true)
    if running && ((RANDOM % 2 == 0 && ${#workers[@]} > 0)); then
        kill -9 "${workers[RANDOM % ${#workers[@]}]}" 2> /dev/null && worker_kills=$((worker_kills + 1))
    elif running; then
        kill -9 "$runner" 2> /dev/null && runner_kills=$((runner_kills + 1))
        wait "$runner" 2> /dev/null || true
        start_runner
        resumes=$((resumes + 1))
    fi
done
wait "$runner" || true
# What is left after the last kill; a run with nothing left to do changes nothing.
"$program" run "${arguments[@]}" -o "$folder/chaos.h5" >> "$folder/chaos.log" 2>&1 || {
    tail -n 20 "$folder/chaos.log"
    exit 1
}
runner=
echo "kills $((runner_kills + worker_kills)): $runner_kills of the runner, $worker_kills of workers; resumes $resumes"
if ((runner_kills + worker_kills == 0)); then
    echo "no kill met a run at work: nothing was tested"
    exit 1
fi
if compgen -G "$folder/chaos.h5.*" > /dev/null; then
    echo "left behind:" "$folder"/chaos.h5.*
    exit 1
fi
/usr/bin/python3 -B "$here/experiments/same_bits.py" "$folder/undisturbed.h5" "$folder/chaos.h5"
