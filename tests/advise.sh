#!/usr/bin/env bash
# `clothbench advise` as a user meets it: on a scene whose truth it has to make, the command
# that it prints runs as it says; what cannot be decided is told; wrong options are refused.
#   advise.sh PROGRAM SOURCE
# shellcheck source=tests/fixture.sh
. "$(dirname "$0")/fixture.sh"
program=$1
export CLOTHBENCH_SCENES=$2/models/scenes
own_folder

# E is twice the stored truth's: it does not hold here.
ask=(advise edge_drop --set material.young=2e5 --until 0.1)
long=(--budget 3600) # for slow builds and emulators
"$program" "${ask[@]}" --error 3% --models mass_spring_single,shell_selective_2,hex "${long[@]}" \
    --out kept >answer.txt 2>log.txt || { cat log.txt; fail "exit $?"; }
[ -s log.txt ] || fail "no progress"
grep -q "^mass-spring.* yes " answer.txt || fail "springs do not serve"

# What is asked of a run is the error less the truth's bar, not more.
tr '\n' ' ' <answer.txt >line.txt
asked=$(grep -o 'accurate enough below [0-9.]* %' line.txt | cut -d' ' -f 4)
bar=$(grep -o "error bar, [0-9.]* %" line.txt | cut -d' ' -f 3)
awk -v asked="$asked" -v bar="$bar" \
    'BEGIN { off = asked - (3 - bar); exit !(bar > 0 && off < 0.01 && off > -0.01) }' ||
    fail "3 % less a bar of $bar % is not $asked %"

# The command, pasted, with the folder's own program.
command=$(sed -n 's/^    clothbench run/run/p' answer.txt)
[[ $command == *"--model "*"discretization.points="*"material.young=2e5"* ]] || fail "command: $command"
eval "\"$program\" $command --set time.end=0.1 --quiet --probe 1,0.5,0.5" >probe.csv 2>log.txt ||
    { cat log.txt; fail "the command fails"; }
[[ $(wc -l <probe.csv) -gt 20 ]] || fail "the command shows no motion"

# Asked again it takes the files that it left and says the same of the truth.
"$program" "${ask[@]}" --error 3% --models mass_spring_single "${long[@]}" \
    --out kept >again.txt 2>log.txt || fail "a second time: exit $?"
bar() { tr '\n' ' ' <"$1" | grep -o 'leaves uncertain by [0-9.]* %'; }
[[ $(bar again.txt) == $(bar answer.txt) && -n $(bar again.txt) ]] || fail "the truth's bar differs a second time"

# A truth that is blunter than the question; a slow build's budget ends before it is found.
"$program" "${ask[@]}" --error 0.0001% --budget 30 --out blunt >blunt.txt 2>log.txt
[[ $? == 1 ]] || fail "blunt: not exit 1"
[ -s blunt.txt ] || fail "blunt: nothing is said"

# A budget ends runs in flight; a scene of one's own has no stored truth, which is no error.
sed 's/^name: .*/name: own/; s/young: [^,]*/young: 2e5/' "$CLOTHBENCH_SCENES/edge_drop.yaml" >own.yaml
SECONDS=0
"$program" advise own.yaml --error 1% --budget 0.5 --out own >own.txt 2>log.txt
[[ $? == 1 && $SECONDS -lt 20 ]] || fail "own: not exit 1, or $SECONDS s of half a second"
[ -s own.txt ] || fail "own: nothing is said"
[ -z "$(find own -name '*.part')" ] || fail "own: leaves parts"
refused advise edge_drop
refused advise edge_drop --budget 0ms
refused advise edge_drop --error 2% --budget 4ms
refused advise edge_drop --error 0
refused advise edge_drop --error 120%
refused advise edge_drop --error 0.5 # a half, or half a per cent?
refused advise edge_drop --error 2%% --out none
refused advise edge_drop --error nan
refused advise edge_drop --error 2% --realtime --seconds 3
refused advise edge_drop --error 2% --budget -1
refused advise edge_drop --error 2% --models nobody --out none
refused advise no_scene --error 2%
[[ ! -e none ]] || fail "a refusal left a folder"
exit $((failures > 0))
