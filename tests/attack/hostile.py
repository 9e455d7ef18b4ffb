# SPDX-License-Identifier: GPL-3.0-or-later
"""Files that were damaged, or made to do damage."""

import json
import re
import shutil
import time

from program import with_memory

MOST_MEMORY = 2 * 1024 ** 3
# Anything that moves the cursor or reverses the direction of a text.
CONTROL = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f\u061c\u200e\u200f\u202a-\u202e\u2066-\u2069]")
TEXTS = (b"\x1b]0;hello\x07", b"\x1b[2J", "\u202ecod".encode(), b"\x00", b"\xef\xbb\xbf", b"\\u0000", b"\\ud800", b"\\u001b[31m",
         b"\xff\xfe", b"\r", b"A" * 70_000, b"[" * 5_000, b"{\"a\":" * 2_000, b"1e999", b"-1", b"99999999999999999999",
         b"0.1", b"null", b"true", b"\"\"", b"=cmd()", b"../../../../etc/passwd", b"\xc2\x9b31m")


def damaged(random, data):
    """One to three changes, each of a different kind."""
    data = bytearray(data)
    for _ in range(random.randint(1, 3)):
        at = random.randrange(len(data) + 1)
        kind = random.randrange(6)
        if kind == 0 and data:
            data[at % len(data)] ^= 1 << random.randrange(8)
        elif kind == 1:
            del data[at:]
        elif kind == 2:
            data[at:at] = random.choice(TEXTS)
        elif kind == 3:
            length = random.randrange(1, 64)
            data[at:at] = data[at:at + length]
        elif kind == 4:
            del data[at:at + random.randrange(1, 64)]
        elif found := list(re.finditer(rb'-?\d+|"[^"]*"', data)):
            one = random.choice(found)
            data[one.start():one.end()] = inside(random, one.group())
    return bytes(data)


def inside(random, token):
    text = random.choice(TEXTS)
    return b'"' + text.replace(b'"', b"") + b'"' if token.startswith(b'"') else text


def shown_in(page):
    """The JSON files that a page shows."""
    return re.findall(rb"```json\n(.*?)```", page.read_bytes(), re.DOTALL)


def kinds(bench):
    """Name, what is damaged, the file's name, and the calls that read it."""
    examples = bench.root / "docs" / "examples"

    def read(folder, pattern):
        return [one.read_bytes() for one in sorted(folder.glob(pattern))]

    def seeds(*names):
        return [bench.seed_of_fuzzer(name) for name in names]

    return (
        ("projects", [*read(examples, "*.codewheel"), *seeds("project/example", "project/numbers", "project/texts")], "hostile.codewheel",
         (("compare", "FILE"), ("report", "FILE", "-o", bench.path("hostile.html"), "--yes"),
          ("read", "1.0", "steps", "--project", "FILE"), ("transfer", "FILE", "--dry-run"),
          ("replace", "1.0", "--project", "FILE", "--dry-run"), ("store", "FILE"))),
        ("cam files", read(examples, "cams.json"), "hostile.json",
         (("cams", "1.0", "compare", "FILE"), ("cams", "1.0", "write", "FILE", "--yes"))),
        ("device descriptions", read(bench.root / "resources" / "devices", "*.json"), "device.json",
         (("devices", "--check", "FILE"),)),
        ("fault plans", shown_in(bench.root / "docs" / "fault-plans.md"), "plan.json",
         (("read", "1.0", "steps", "--fault-plan", "FILE"),)),
        ("accounts", seeds("journal/ledger"), "hostile-ledger.sqlite",
         (("ledger", "--ledger", "FILE"), ("write", "1.0", "steps=4096", "--yes", "--ledger", "FILE"))),
        ("messages", seeds("journal/messages", "journal/messages-scratched", "journal/messages-wal"), "hostile-messages.sqlite",
         (("messages", "--file", "FILE", "--last", "0"),
          ("messages", "--file", "FILE", "--export", bench.path("hostile.csv"), "--yes"))),
    )


def files(bench, random, until, findings):
    """Refused with a sentence, or read; never a signal, a hang, much memory, or an escape sequence."""
    number = 0
    while time.monotonic() < until:
        for name, begins, file, calls in kinds(bench):
            number += 1
            data = damaged(random, random.choice(begins))
            folder = bench.path(f"hostile-{number}")
            folder.mkdir()
            path = folder / file
            path.write_bytes(data)
            findings.tries(f"damaged {name}")
            call = tuple(path if one == "FILE" else one for one in random.choice(calls))
            losses = len(findings.lost)
            try_one(bench, findings, call + (("--json",) if random.random() < 0.3 else ()))
            if len(findings.lost) == losses:
                shutil.rmtree(folder)


def try_one(bench, findings, call):
    run = bench.run(*call, prepare=with_memory(MOST_MEMORY))
    if run.code not in (0, 1, 2):
        findings.loses(run)
        return
    if run.code != 0 and not run.err and "--json" not in call:
        findings.loses(f"without a sentence: {run}")
    for what, text in (("output", run.out), ("standard error", run.err)):
        try:
            found = CONTROL.search(text.decode())
        except UnicodeDecodeError:
            findings.loses(f"{what} is no UTF-8: {run}")
            continue
        if found:
            findings.loses(f"{what} has U+{ord(found.group()):04X}: {run}")
    if "--json" in call and run.out:
        try:
            json.loads(run.out)
        except ValueError:
            findings.loses(f"no JSON: {run}")
