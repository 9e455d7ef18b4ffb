#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Attacks codewheel-cli: kills, parallel processes, full disks, output that cannot be written, hostile files, bad networks.

Prints what it tried and what was lost by it; exit code 1 if anything was. What it does is drawn from --seed, which
is printed; when things happen is up to the machine.
"""

import argparse
import pathlib
import random
import shutil
import signal
import sys
import tempfile
import time

import can
import disk
import gateway
import hostile
import journal
import ledger
import output
import project
import recording
from findings import Findings
from program import Bench

ATTACKS = {
    "ledger-parallel": ledger.parallel,
    "ledger-killed": ledger.killed,
    "project-parallel": project.parallel,
    "project-killed": project.killed,
    "journal-killed": journal.killed,
    "recording-killed": recording.killed,
    "disk-full": disk.full,
    "output": output.unwritable,
    "hostile-files": hostile.files,
    "gateway-network": gateway.bad_network,
    "can-adapter": can.bad_adapter,
}


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--cli", required=True, help="the program codewheel-cli")
    parser.add_argument("--writer", required=True, help="the program journal_writer")
    parser.add_argument("--seconds", type=float, default=40, help="for all attacks together")
    parser.add_argument("--seed", type=int, default=None, help="else another one each time")
    parser.add_argument("--keep", action="store_true", help="leave the folder in which it worked")
    parser.add_argument("attacks", nargs="*", metavar="ATTACK", help="of these: " + ", ".join(ATTACKS))
    arguments = parser.parse_args()
    for name in arguments.attacks:
        if name not in ATTACKS:
            parser.error(f"there is no attack {name}")
    return arguments


def main():
    arguments = parse_arguments()
    signal.signal(signal.SIGPIPE, signal.SIG_DFL)
    seed = arguments.seed if arguments.seed is not None else random.SystemRandom().randrange(10 ** 6)
    print(f"seed {seed}; again with --seed {seed}", flush=True)
    root = pathlib.Path(__file__).resolve().parent.parent.parent
    names = arguments.attacks or list(ATTACKS)
    lost = 0
    folder = pathlib.Path(tempfile.mkdtemp(prefix="codewheel-attack-"))
    for name in names:
        own = folder / name
        own.mkdir()
        findings = Findings()
        until = time.monotonic() + arguments.seconds / len(names)
        ATTACKS[name](Bench(arguments.cli, arguments.writer, root, own), random.Random(f"{seed} {name}"), until, findings)
        findings.print(name)
        lost += len(findings.lost)
    print(f"Lost in all: {lost}.", flush=True)
    if arguments.keep or lost > 0:
        print(f"The files are in {folder}.", flush=True)
    else:
        shutil.rmtree(folder, ignore_errors=True)
    return 1 if lost > 0 else 0


if __name__ == "__main__":
    sys.exit(main())
