# SPDX-License-Identifier: GPL-3.0-or-later
"""A recording: it is read while it is written, another program wants the same file, and its program is killed."""

import time


def told(bench, file):
    """What `export` says of it; None: it cannot be read."""
    run = bench.run("export", file, "--json")
    return run.answer() if run.code == 0 else None


def killed(bench, random, until, findings):
    """What a reader has seen is still there after the kill, and becomes a table."""
    number = 0
    while time.monotonic() < until:
        number += 1
        file = bench.path(f"shaft-{number}.cwrec")
        call = bench.start("record", "4.0", "05", "-o", file)
        time.sleep(random.uniform(0, 2.5))
        findings.tries("readers meanwhile")
        before = told(bench, file)
        if before and random.random() < 0.5:
            findings.tries("others that want the file")
            if bench.run("record", "4.0", "-o", file, "--for", "1").code != 2:
                findings.loses(f"{file.name} was recorded into by two programs")
        call.kill()
        call.wait()
        findings.tries("recordings killed")
        if not before:
            continue
        after = told(bench, file)
        if after is None:
            findings.loses(f"{file.name} cannot be read after the kill: {bench.run('export', file)}")
        elif after["until"] < before["until"] or after["ended"]:
            findings.loses(f"{file.name} was there until {before['until']}, and is until {after['until']}")
        elif after["encoders"] and bench.run("export", file, "-o", bench.path(f"shaft-{number}.csv")).code != 0:
            findings.loses(f"{file.name} makes no table")
