# SPDX-License-Identifier: GPL-3.0-or-later
"""Output that cannot be written: what was done to the encoder is still reported."""

import os
import shutil
import signal
import time

from program import closed


def commands(bench):
    ledger = ("--ledger", bench.path("output.sqlite"))
    plant = bench.path("plant.codewheel")
    return (
        ("--help",), ("--version",), ("devices",), ("devices", "fraba-ocd-ib"), ("scan",), ("read", "1.0"),
        ("explain", "020000FF", "--device", "fraba-ocd-ib", "--direction", "out"),
        ("write", "1.0", "steps=4096", "--yes", "--beyond-eeprom-limit", "1.0", *ledger),
        ("preset", "1.0", "100", *ledger), ("cams", "1.0", "read"), ("monitor", "2.0", "--for", "1"),
        ("words", "1.0", "020000FF", "80000000", "--yes", *ledger), ("ledger", *ledger),
        ("compare", bench.example("training.codewheel")), ("store", plant),
        ("report", plant, "-o", bench.path("report.html"), "--yes"),
        ("clone", "1.0", "6.1", "--dry-run"), ("master", "status"), ("restore", "1.0", "--list", *ledger))


def to_nobody():
    """The write end of a pipe that nobody reads."""
    reading, writing = os.pipe()
    os.close(reading)
    return writing


def unwritable(bench, random, until, findings):
    """Exit code 1 with a sentence; a signal only if a pipe lost its reader; no file gets the terminal's output."""
    plant = bench.path("plant.codewheel")
    shutil.copy(bench.example("training.codewheel"), plant)
    refused = [run for run in (bench.run(*command) for command in commands(bench)) if run.code != 0]
    if refused:
        raise RuntimeError(f"this should be done where it can be told: {refused[0]}")
    while time.monotonic() < until:
        for command in random.sample(commands(bench), len(commands(bench))):
            arguments = command + (("--json",) if random.random() < 0.3 else ())
            for how in ("full", "closed", "left", "both"):
                try_one(bench, findings, arguments, how)
            broken = bench.run("compare", plant, "--json")
            if broken.code != 0:
                findings.loses(f"the project is no more what it was: {broken}")
                shutil.copy(bench.example("training.codewheel"), plant)


def try_one(bench, findings, arguments, how):
    findings.tries({"full": "times a full device", "closed": "times closed", "left": "times a pipe nobody reads",
                    "both": "times standard error full as well"}[how])
    if how == "closed":
        run = bench.run(*arguments, prepare=closed(1))
    elif how == "left":
        writing = to_nobody()
        run = bench.run(*arguments, stdout=writing)
        os.close(writing)
    else:
        with open("/dev/full", "wb") as full:
            run = bench.run(*arguments, stdout=full, stderr=full if how == "both" else None)
    mayBeSignal = how == "left" and run.code == -signal.SIGPIPE and arguments[0] not in ("write", "preset", "words")
    if mayBeSignal:
        return
    if run.code != 1:
        findings.loses(f"output {how}: {run}")
    elif not run.err and how != "both":
        findings.loses(f"output {how}, without a sentence: {run}")
