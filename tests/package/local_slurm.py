# SPDX-License-Identifier: BSL-1.0
"""A Slurm of this machine alone, which the present user runs: one node with two processors."""

import os
import pathlib
import shutil
import socket
import subprocess
import time

PROGRAMS = ("slurmctld", "slurmd", "sbatch", "srun", "scontrol", "sinfo")
PATIENCE = 60  # seconds until the daemons must be ready

CONFIGURATION = """\
ClusterName=local
SlurmctldHost={host}(127.0.0.1)
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/none
CredType=cred/none
SlurmctldPort={controller_port}
SlurmdPort={node_port}
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
ReturnToService=2
SlurmctldPidFile={work}/slurmctld.pid
SlurmdPidFile={work}/slurmd.pid
StateSaveLocation={work}/state
SlurmdSpoolDir={work}/spool
SlurmctldLogFile={work}/slurmctld.log
SlurmdLogFile={work}/slurmd.log
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
MpiDefault=none
SchedulerType=sched/builtin
SchedulerParameters=sched_interval=1,sched_min_interval=0
NodeName={host} NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""


def missing_programs():
    """The programs of Slurm that this machine lacks. Debian installs the daemons outside a user's PATH."""
    return [program for program in PROGRAMS if shutil.which(program, path=search_path()) is None]


def search_path():
    return os.pathsep.join([os.environ.get("PATH", ""), "/usr/local/sbin", "/usr/sbin"])


def free_port():
    with socket.socket() as one:
        one.bind(("127.0.0.1", 0))
        return one.getsockname()[1]


class LocalSlurm:
    """Starts the daemons in a folder, and ends them."""

    def __init__(self, work):
        self.work = pathlib.Path(work)
        self.daemons = []
        self.environment = {**os.environ, "PATH": search_path(), "SLURM_CONF": str(self.work / "slurm.conf")}
        # Variables of a job in which this program may itself run.
        for name in [name for name in self.environment if name.startswith(("SLURM_", "OMPI_")) and name != "SLURM_CONF"]:
            del self.environment[name]

    def __enter__(self):
        for folder in ("state", "spool"):
            (self.work / folder).mkdir(parents=True)
        host = socket.gethostname().split(".")[0]
        user = subprocess.run(["id", "-un"], check=True, capture_output=True, text=True).stdout.strip()
        (self.work / "slurm.conf").write_text(CONFIGURATION.format(
            host=host, user=user, work=self.work, controller_port=free_port(), node_port=free_port()), encoding="utf-8")
        for daemon in ("slurmctld", "slurmd"):
            log = (self.work / f"{daemon}.out").open("w", encoding="utf-8")
            self.daemons.append(subprocess.Popen([shutil.which(daemon, path=search_path()), "-D"], stdout=log, stderr=log,
                                                 env=self.environment))
        end = time.monotonic() + PATIENCE
        while "idle" not in self.run("sinfo", "--noheader", "--format=%T").stdout:
            if time.monotonic() > end:
                self.__exit__()
                raise RuntimeError("Slurm does not start:\n" + self.logs())
            time.sleep(0.2)
        return self

    def __exit__(self, *_):
        for daemon in self.daemons:
            daemon.terminate()
        for daemon in self.daemons:
            daemon.wait()

    def run(self, *command, **options):
        return subprocess.run(command, env=self.environment, capture_output=True, text=True, check=False, **options)

    def logs(self):
        return "".join(file.read_text(encoding="utf-8") for file in sorted(self.work.glob("slurm*.log")))
