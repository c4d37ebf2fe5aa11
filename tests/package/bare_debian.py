# SPDX-License-Identifier: BSL-1.0
"""A bare Debian 12 (debootstrap's minbase). Commands in it see none of the machine's packages."""

import os
import pathlib
import shlex
import shutil
import subprocess

SUITE = "bookworm"
PATH = "/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin"
# Some networks have their own certificate authority.
CERTIFICATES = pathlib.Path("/etc/ssl/certs/ca-certificates.crt")
SKIPPED = 77  # the exit status of a test that cannot run here


class Unavailable(Exception):
    """The reason why this machine cannot make a bare Debian."""


def mirror():
    """The mirror from which this machine gets Debian 12."""
    found = subprocess.run(
        ["apt-get", "indextargets", "--format", "$(REPO_URI)", "Created-By: Packages", f"Codename: {SUITE}",
         "Component: main"], capture_output=True, text=True, check=False)
    addresses = found.stdout.split()
    if not addresses:
        raise Unavailable(f"apt knows no mirror of {SUITE}")
    return addresses[0]


def make_base(folder):
    """Makes the bare system once. Other systems are copies of it."""
    if os.geteuid() != 0:
        raise Unavailable("making a chroot needs root")
    for program in ("debootstrap", "unshare", "chroot", "apt-get"):
        if not shutil.which(program):
            raise Unavailable(f"there is no {program}; Debian has it in a package (debootstrap, util-linux, coreutils, apt)")
    if (folder / "made").exists():
        return
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    with open(folder / "log", "w", encoding="utf-8") as log:
        made = subprocess.run(["debootstrap", "--variant=minbase", SUITE, folder / "root", mirror()], stdout=log,
                              stderr=subprocess.STDOUT, check=False)
    if made.returncode != 0:
        lines = (folder / "log").read_text(encoding="utf-8", errors="replace").splitlines()
        raise Unavailable("debootstrap: " + (lines[-1] if lines else f"status {made.returncode}"))
    (folder / "made").touch()


class BareDebian:
    """A copy of the bare system. `binds` maps its folders to folders of this machine."""

    def __init__(self, base, root):
        make_base(base)
        self.root = root
        shutil.rmtree(root, ignore_errors=True)
        root.parent.mkdir(parents=True, exist_ok=True)
        subprocess.run(["cp", "-a", base / "root", root], check=True)
        for name in ("resolv.conf", "hosts"):
            if pathlib.Path("/etc", name).exists():
                shutil.copyfile(pathlib.Path("/etc", name), root / "etc" / name)
        proxies = subprocess.run(["apt-config", "dump", "Acquire::http::Proxy"], capture_output=True, text=True, check=False)
        (root / "etc/apt/apt.conf.d/90proxy").write_text(proxies.stdout, encoding="utf-8")
        self.environment = {"PATH": PATH, "HOME": "/root", "LC_ALL": "C.UTF-8", "DEBIAN_FRONTEND": "noninteractive"}
        if CERTIFICATES.exists():
            shutil.copyfile(CERTIFICATES, root / "etc/certificates-of-the-network.crt")
            self.environment["NODE_EXTRA_CA_CERTS"] = "/etc/certificates-of-the-network.crt"
        self.binds = {}

    def run(self, command, environment=None, folder="/", log=None):
        """Runs a command (a list of words), ends its remaining processes, and returns its exit status."""
        words = ["env", "-i", *(f"{name}={value}" for name, value in (self.environment | (environment or {})).items())]
        root = shlex.quote(str(self.root))
        mounts = [f"mount --rbind /dev {root}/dev", f"mount -t proc proc {root}/proc", f"mount -t sysfs sysfs {root}/sys"]
        for inside, outside in self.binds.items():
            target = self.root / inside.lstrip("/")
            target.mkdir(parents=True, exist_ok=True)
            mounts.append(f"mount --bind {shlex.quote(str(outside))} {shlex.quote(str(target))}")
        inner = f"cd {shlex.quote(folder)} && exec {shlex.join(command)}"
        mounts.append(f"exec chroot {root} {shlex.join(words)} /bin/sh -c {shlex.quote(inner)}")
        script = " && ".join(mounts)
        return subprocess.run(["unshare", "--mount", "--pid", "--fork", "--kill-child", "/bin/sh", "-c", script],
                              stdin=subprocess.DEVNULL, stdout=log, stderr=subprocess.STDOUT if log else None,
                              check=False).returncode

    def remove(self):
        shutil.rmtree(self.root, ignore_errors=True)
