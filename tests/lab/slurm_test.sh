#!/bin/bash
# Runs the job array of docs/lab.md under a Slurm of its own: one node, this machine, with munge. What the shares have
# computed must merge into the table of a single run.
# usage: slurm_test.sh DRAPE_LAB DOCS/LAB.MD     exit code 77: there is no Slurm here, or its daemons may not be started
set -eu
lab=$(realpath "$1") page=$(realpath "$2") shares=3
selection="--quick --cases 157-162"
for program in munged slurmctld slurmd sbatch scontrol; do
  PATH=$PATH:/usr/sbin command -v $program >/dev/null || { echo "there is no $program"; exit 77; }
done
[ "$(id -u)" = 0 ] || { echo "the daemons of Slurm need root"; exit 77; }
export PATH=$PATH:/usr/sbin
folder=$(mktemp -d)
chmod 755 "$folder"  # munged wants its socket to be within reach
daemons=()

# Ends the daemons that were started here, by their numbers, and waits until they are gone.
clean_up() {
  code=$?
  for daemon in "${daemons[@]}"; do kill "$daemon" 2>/dev/null || true; done
  for daemon in "${daemons[@]}"; do wait "$daemon" 2>/dev/null || true; done
  [ $code = 0 ] || tail -n 30 "$folder"/*.log "$folder"/slurm-*.out 2>/dev/null
  rm -rf "$folder"
  exit $code
}
trap clean_up EXIT

# Asks again and again until a command succeeds: a daemon answers as soon as it can.
until_it_works() {
  local end=$((SECONDS + 60))
  until "$@" >/dev/null 2>&1; do
    [ $SECONDS -lt $end ] || { echo "gave up on: $*"; exit 1; }
    read -rt 0.1 <> <(:) || true
  done
}

free_port() {
  local port
  while port=$((20000 + RANDOM % 10000)); (: < /dev/tcp/127.0.0.1/$port) 2>/dev/null; do :; done
  echo $port
}

cd "$folder"
(umask 077; head -c 128 /dev/urandom > munge.key)
munged --foreground --force --key-file="$folder/munge.key" --socket="$folder/munge.socket" \
  --pid-file="$folder/munged.pid" --seed-file="$folder/munge.seed" --log-file="$folder/munged.log" 2> munged_start.log &
daemons+=($!)
until_it_works munge --socket="$folder/munge.socket" --no-input

mkdir state spool
cat > slurm.conf <<END
ClusterName=drape
SlurmctldHost=$(hostname -s)(127.0.0.1)
SlurmctldPort=$(free_port)
SlurmdPort=$(free_port)
AuthType=auth/munge
AuthInfo=socket=$folder/munge.socket
SlurmUser=root
SlurmdUser=root
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
MpiDefault=none
NodeName=$(hostname -s) NodeAddr=127.0.0.1 CPUs=$(nproc)
PartitionName=all Nodes=ALL Default=YES MaxTime=60 State=UP
END
echo "CgroupPlugin=cgroup/v1" > cgroup.conf  # touches none where no plugin asks: a container may have none
export SLURM_CONF=$folder/slurm.conf
slurmctld -D -c > slurmctld.log 2>&1 &
daemons+=($!)
until_it_works scontrol ping
slurmd -D > slurmd.log 2>&1 &
daemons+=($!)
until_it_works sh -c "sinfo --noheader --format=%t | grep -q idle"

# The script as the page has it, but for the program, the cases and the number of shares
sed -n '/^#!\/bin\/bash/,/^```/p' "$page" | sed '/^```/d' |
  sed "s|build/release/bin/drape-lab stability|'$lab' stability $selection|; s|1-64|1-$shares|; s|/64|/$shares|" > array.sh
grep -q "SBATCH --array=1-$shares" array.sh
grep -q "SLURM_ARRAY_TASK_ID/$shares" array.sh
sbatch --wait array.sh
ls -d stability-*-$shares
"$lab" merge stability-*-$shares --out merged >/dev/null
PATH=/nowhere "$lab" stability $selection --out whole >/dev/null
cmp merged/stability.csv whole/stability.csv
echo "the array of $shares jobs has computed the table of a single run"
