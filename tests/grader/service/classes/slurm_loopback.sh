# shellcheck shell=bash
# For tests, to be sourced: Slurm on this machine alone, with one node.

# why_no_slurm: prints why a test is skipped; nothing if Slurm can be started.
why_no_slurm() {
  local program
  [ "$(id -u)" -eq 0 ] || { echo 'slurmd can only be started by root: not tried'; return; }
  for program in munged slurmctld slurmd sbatch; do
    PATH=$PATH:/usr/sbin command -v "$program" >/dev/null || { echo "$program is missing (munge, slurm-wlm): not tried"; return; }
  done
}

# a_free_port: prints a free TCP port of this machine.
a_free_port() {
  python3 -c 'import socket; s = socket.socket(); s.bind(("127.0.0.1", 0)); print(s.getsockname()[1])'
}

# start_slurm FOLDER: writes all its files there. Sets SLURM_CONF.
start_slurm() {
  local folder=$1 host
  host=$(hostname -s)
  PATH=$PATH:/usr/sbin
  export SLURM_CONF=$folder/slurm.conf
  mkdir -p "$folder/munge" "$folder/state" "$folder/spool"
  chmod 755 "$folder"
  chmod 700 "$folder/munge"
  head -c 64 /dev/urandom >"$folder/munge/key"
  chmod 400 "$folder/munge/key"
  munged --force --key-file="$folder/munge/key" --socket="$folder/munge/socket" --pid-file="$folder/munge.pid" \
    --log-file="$folder/munge/log" --seed-file="$folder/munge/seed"
  cat >"$SLURM_CONF" <<END
ClusterName=loopback
SlurmctldHost=$host(127.0.0.1)
AuthType=auth/munge
AuthInfo=socket=$folder/munge/socket
SlurmUser=root
SlurmdUser=root
SlurmctldPort=$(a_free_port)
SlurmdPort=$(a_free_port)
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SwitchType=switch/none
MpiDefault=none
ReturnToService=2
KillWait=2
NodeName=$host NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
END
  slurmctld -f "$SLURM_CONF"
  slurmd -f "$SLURM_CONF"
  local _
  for _ in $(seq 100); do
    ! sinfo -h -o %T 2>/dev/null | grep -q idle || return 0
    sleep 0.2
  done
  tail -n 5 "$folder"/*.log >&2
  return 1
}

# stop_slurm FOLDER: also stops everything that it still runs.
stop_slurm() {
  [ -e "$1/slurm.conf" ] || return 0
  scancel --user=root 2>/dev/null || true
  local daemon pid
  for daemon in slurmd slurmctld munge; do
    [ -e "$1/$daemon.pid" ] || continue
    pid=$(cat "$1/$daemon.pid")
    kill "$pid" 2>/dev/null || continue
    while kill -0 "$pid" 2>/dev/null; do sleep 0.1; done
  done
}
