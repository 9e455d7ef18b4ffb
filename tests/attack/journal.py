# SPDX-License-Identifier: GPL-3.0-or-later
"""One file of messages: several programs write to it, others read it, and writers are killed."""

import subprocess
import time


class Writer:
    """tests/journal/journal_writer.cpp: prints what it was promised to be on disk."""

    def __init__(self, bench, messages, ledger, number):
        self.number = number
        self._process = subprocess.Popen([bench.writer, messages, ledger, str(number)], text=True,
                                         stdout=subprocess.PIPE, env=bench.environment)

    def kill_and_promised(self):
        self._process.kill()
        said, _ = self._process.communicate()
        whole = said[:said.rfind("\n") + 1].splitlines()
        numbers = [int(line.split()[1]) for line in whole if line.startswith("message ")]
        return max(numbers, default=-1), sum(line == "write" for line in whole)


def kept(bench, messages, findings):
    """The message numbers of each writer."""
    run = bench.run("messages", "--file", messages, "--last", "0", "--json")
    if run.code != 0:
        findings.loses(f"the messages cannot be read: {run}")
        return None
    numbers = {}
    for message in run.answer().get("messages", []):
        if message["code"] == "training":
            words = message["arguments"][0].split()
            numbers.setdefault(int(words[0]), []).append(int(words[1]))
    return numbers


def killed(bench, random, until, findings):
    """What was promised is there, without a gap and only once, whoever is reading meanwhile."""
    number = 0
    file = 0
    while time.monotonic() < until:
        file += 1
        messages, ledger = bench.path(f"messages-{file}.sqlite"), bench.path(f"journal-ledger-{file}.sqlite")
        writers = []
        for _ in range(random.choice((1, 2, 3))):
            number += 1
            writers.append(Writer(bench, messages, ledger, number))
        time.sleep(random.uniform(0.05, 0.3))
        for _ in range(random.randint(0, 4)):
            findings.tries("readers meanwhile")
            bench.run("messages", "--file", messages, "--last", "5")
        writes = 0
        promised = {}
        for writer in writers:
            time.sleep(random.uniform(0, 0.1))
            promised[writer.number], written = writer.kill_and_promised()
            writes += written
            findings.tries("writers killed")
        if max(promised.values()) < 0:
            continue
        there = kept(bench, messages, findings)
        if there is None:
            continue
        for one, last in promised.items():
            found = sorted(there.get(one, []))
            if found != list(range(len(found))) or len(found) <= last:
                findings.loses(f"writer {one} was promised {last + 1} messages in {messages.name}, "
                               f"{len(found)} are there: {found[:3]} ... {found[-3:]}")
        run = bench.run("ledger", "--ledger", ledger, "--json")
        counted = sum(account["writes"] for account in run.answer().get("accounts", []))
        if counted < writes:
            findings.loses(f"{writes} EEPROM writes were promised in {ledger.name}, {counted} are counted")
