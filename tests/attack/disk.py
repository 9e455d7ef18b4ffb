# SPDX-License-Identifier: GPL-3.0-or-later
"""A full disk: everything that saves reports it, and the old file is still there."""

import json
import os
import shutil
import subprocess
import time

from program import at_most

PAGE = 4096
OLD = b"the old file\n"


class SmallDisk:
    """A tmpfs in a mount namespace of its own, if one may be made; otherwise each file has a limit."""

    SIZE = 512 * 1024

    def __init__(self, bench):
        self.folder = bench.path("disk")
        self.folder.mkdir(exist_ok=True)
        self._holder = None
        rights = [] if os.geteuid() == 0 else ["--user", "--map-root-user"]
        script = f'mount -t tmpfs -o size={self.SIZE} tmpfs "$1" && echo mounted && exec cat'
        try:
            holder = subprocess.Popen(["unshare", *rights, "--mount", "sh", "-c", script, "sh", str(self.folder)],
                                      stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
        except OSError:
            return
        if holder.stdout.readline() != b"mounted\n":
            holder.communicate()
            return
        self._holder = holder
        users = [] if os.geteuid() == 0 else ["--user", "--preserve-credentials"]
        self._prefix = ["nsenter", "--target", str(holder.pid), *users, "--mount", "--"]

    def name(self):
        return "a small tmpfs" if self._holder else "a limit for each file (no tmpfs may be mounted here)"

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self._holder:
            self._holder.communicate()

    def seen(self, path):
        """The path by which this process sees what the program sees."""
        return path if not self._holder else type(path)(f"/proc/{self._holder.pid}/root{path}")

    def clear(self):
        for one in self.seen(self.folder).iterdir():
            one.unlink() if not one.is_dir() else shutil.rmtree(one)

    def leave(self, free):
        """How to make the next call so that this many bytes are left."""
        if not self._holder:
            return {"prepare": at_most(max(free, PAGE))}  # what it says goes to a file as well
        used = os.statvfs(self.seen(self.folder))
        fill = used.f_bavail * used.f_frsize - free
        with open(self.seen(self.folder / "filler"), "wb") as filler:
            filler.write(bytes(max(fill, 0)))
        return {"prefix": self._prefix}

    def free(self):
        self.seen(self.folder / "filler").unlink(missing_ok=True)

    def anyway(self):
        return {"prefix": self._prefix} if self._holder else {}


def is_json(saved):
    try:
        json.loads(saved)
    except ValueError:
        return False
    return True


def savers(bench, disk):
    """Name, arguments, file, and how to tell that a file is complete."""
    example = bench.example("training.codewheel")
    cams, page, paper = (disk.folder / name for name in ("cams.json", "report.html", "report.pdf"))
    plant, account, table = (disk.folder / name for name in ("plant.codewheel", "account.html", "messages.csv"))
    return (
        ("cams read", ("cams", "1.0", "read", cams, "--yes"), cams, is_json),
        ("report as a page", ("report", example, "-o", page, "--yes"), page, lambda saved: b"</html>" in saved),
        ("report on paper", ("report", example, "-o", paper, "--yes"), paper, lambda saved: b"%%EOF" in saved),
        ("scan --save", ("scan", "--save", plant, "--yes"), plant, is_json),
        ("store", ("store", plant), plant, is_json),
        ("replace", ("replace", "1.0", "--project", plant, "--serial", "77", "--yes"), plant, is_json),
        ("account of transfer", ("transfer", example, "1.0", "--report", account, "--yes"), account,
         lambda saved: b"</html>" in saved),
        ("messages --export", ("messages", "--file", bench.path("messages.sqlite"), "--last", "0", "--export", table,
                               "--yes"), table, lambda saved: saved.endswith(b"\n") and saved.count(b"\n") > 1),
    )


def try_saver(bench, disk, random, findings, saver):
    name, arguments, path, is_complete = saver
    disk.clear()
    isProject = path.suffix == ".codewheel"
    old = bench.example("training.codewheel").read_bytes() if isProject else OLD
    disk.seen(path).write_bytes(old)
    run = bench.run(*arguments, **disk.leave(random.choice((0, 0, PAGE, 2 * PAGE, random.randint(0, 32 * PAGE)))))
    findings.tries(f"times {name}")
    disk.free()
    there = disk.seen(path).read_bytes() if disk.seen(path).exists() else None
    if not run.ended_by_itself():
        findings.loses(run)
    elif run.code == 0 and (there is None or there == old or not is_complete(there)):
        findings.loses(f"told as saved, and it is not: {run}; {0 if there is None else len(there)} bytes")
    elif run.code != 0 and not run.err:
        findings.loses(f"without a sentence: {run}")
    elif run.code != 0 and there != old and not (there and is_complete(there)):
        findings.loses(f"the old file is gone: {run}; {0 if there is None else len(there)} bytes")


def try_ledger(bench, disk, random, findings):
    disk.clear()
    ledger = disk.folder / "ledger.sqlite"
    write = ("write", "1.0", "steps=4096", "--all", "--yes", "--json", "--ledger", ledger)
    if random.random() < 0.7 and bench.run(*write, **disk.anyway()).code != 0:
        findings.loses("the account cannot be begun")
        return
    before = counted(bench, disk, ledger)
    run = bench.run(*write, **disk.leave(random.choice((0, 0, PAGE, random.randint(0, 16 * PAGE)))))
    findings.tries("EEPROM writes to be counted")
    disk.free()
    after = counted(bench, disk, ledger)
    if not run.ended_by_itself():
        findings.loses(run)
    elif after is None:
        findings.loses(f"the account cannot be read after {run}")
    elif after < (before or 0) + (run.answer().get("eepromWrites") or 0) and not (run.code == 1 and run.err):
        findings.loses(f"{before} writes before, {after} after, and nothing said so: {run}")


def counted(bench, disk, ledger):
    if not disk.seen(ledger).exists():
        return 0
    run = bench.run("ledger", "--ledger", ledger, "--json", **disk.anyway())
    return sum(one["writes"] + one["perhaps"] for one in run.answer().get("accounts", [])) if run.code == 0 else None


def full(bench, random, until, findings):
    """A sentence each time, never a signal; what is reported as saved is saved."""
    bench.path("messages.sqlite").write_bytes(bench.seed_of_fuzzer("journal/messages"))
    with SmallDisk(bench) as disk:
        print(f"  the full disk is {disk.name()}", flush=True)
        while time.monotonic() < until:
            for saver in savers(bench, disk):
                try_saver(bench, disk, random, findings, saver)
                try_ledger(bench, disk, random, findings)
