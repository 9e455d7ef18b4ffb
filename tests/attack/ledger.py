# SPDX-License-Identifier: GPL-3.0-or-later
"""One account of EEPROM writes: many processes use it at once, and are killed at random moments."""

import time

WRITE = ("write", "1.0", "revolutions=1", "--all", "--yes", "--beyond-eeprom-limit", "1.0", "--json")


def write(random, ledger):
    return (*WRITE[:2], f"steps={random.randint(255, 8000)}", *WRITE[2:], "--ledger", ledger)


def counts(bench, ledger, findings):
    """Writes, and possible writes besides; nothing if the account cannot be read."""
    run = bench.run("ledger", "--ledger", ledger, "--json")
    if run.code != 0:
        findings.loses(f"the account cannot be read: {run}")
        return None
    accounts = run.answer().get("accounts", [])
    return sum(one["writes"] for one in accounts), sum(one["perhaps"] for one in accounts)


def told(run):
    return run.answer().get("eepromWrites") or 0


def look_for_damage(bench, findings):
    for name in bench.folder.iterdir():
        if "damaged" in name.name:
            findings.loses(f"a file was put aside as damaged: {name.name}")


def parallel(bench, random, until, findings):
    """Every reported write is counted once, however many processes write."""
    ledger = bench.path("parallel.sqlite")
    written = 0
    while time.monotonic() < until:
        calls = [bench.start(*write(random, ledger)) for _ in range(random.choice((2, 4, 8, 16, 32)))]
        findings.tries("processes that wrote at once", len(calls))
        for run in [call.wait() for call in calls]:
            written += told(run)
            if not run.ended_by_itself() or (run.code != 0 and not run.err):
                findings.loses(run)
        count = counts(bench, ledger, findings)
        if count is None:
            return
        if count[0] != written or count[1] != 0:
            findings.loses(f"{written} writes were told, {count[0]} are counted, {count[1]} perhaps")
            written = count[0]
    look_for_damage(bench, findings)


def killed(bench, random, until, findings):
    """What was reported is counted, and what was under way counts at most as possibly written."""
    ledger = bench.path("killed.sqlite")
    usual = bench.run(*write(random, ledger))
    least = most = told(usual)
    while time.monotonic() < until:
        calls = [bench.start(*write(random, ledger)) for _ in range(random.choice((1, 2, 4)))]
        time.sleep(random.uniform(0, 1.2 * usual.seconds))
        victims = random.sample(calls, random.randint(1, len(calls)))
        for call in victims:
            call.kill()
        findings.tries("kills", len(victims))
        for run in [call.wait() for call in calls]:
            least += told(run)
            most += 2 # values in each call
        count = counts(bench, ledger, findings)
        if count is None:
            return
        if not least <= sum(count) <= most:
            findings.loses(f"{least} writes were told and {most} begun, {count[0]} are counted, {count[1]} perhaps")
            least = sum(count)
    look_for_damage(bench, findings)
