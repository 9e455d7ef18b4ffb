# SPDX-License-Identifier: GPL-3.0-or-later
"""The calls that are recorded: every command, every encoder of the training bus, every job, and what is refused."""

import json
import shutil
import subprocess

RING = ("1.0", "2.0", "3.0", "4.0", "5.0", "6.1")
LINE = ("03", "05", "12")
PLACES = RING + LINE

# As many words as there are kinds of answers, not all there are.
WORDS = ("00000000", "80000000", "40000000", "C0000000", "20000FFF", "020000FF", "C20000FF", "0400FFFF", "86000000",
         "C6000010", "A0002000", "E0000001", "08000001", "C8000001", "10000000", "12345678", "FFFFFFFF", "7FFFFFFF")
REQUESTS = ("03P", "03GP00005200", "05V", "12GS00001000", "0S", "03Q", "XYZ")
PARAMETERS = ("steps", "revolutions", "direction", "coding", "preset", "zero-offset", "offset", "measuring-range")


def answer(cli, *arguments):
    """Of a question about what there is; asked in English, whatever is recorded."""
    return json.loads(subprocess.run([cli, *arguments, "--json"], capture_output=True, check=True).stdout)


def calls(root, work, cli):
    """Lists of arguments, in the order in which they are to be made in the folder `work`."""
    for name in ("crane", "training", "two-encoders"):
        shutil.copy(root / f"docs/examples/{name}.codewheel", work)
    shutil.copy(root / "docs/examples/cams.json", work)
    shutil.copy(root / "docs/examples/commissioning.log", work)
    shutil.copy(root / "resources/examples/faults.json", work)
    for call in (["scan"], ["monitor", "can:5"], ["monitor", "can:6"], ["read", "can:5"], ["record", "-o", "log.cwrec"]):
        for settings in ("", ",usual-mapping=yes"):
            yield [*call, "--link", f"log:commissioning.log{settings}"]
    for name in ("whole.dcf", "compact.eds", "odd.eds", "encoder.eds"):
        shutil.copy(root / "tests/fuzz/corpus/eds" / name, work)
    commands = [command["name"] for command in answer(cli, "--help")["commands"]]
    devices = [device["name"] for device in answer(cli, "devices")["devices"]]
    yield ["--help"]
    yield ["--version"]
    for command in commands:
        yield [command, "--help"]
    for part in (descriptions(devices), words(devices), looking(), writing(), functions(), projects(), recordings(),
                 ledgers(), masters(), can_buses(), refused(commands)):
        yield from part


def descriptions(devices):
    yield ["devices"]
    for device in devices:
        yield ["devices", device]
    for label in ("OCD-IBA1B-1213-C100-PRI", "OCD-IBC1B-0012-S060-PRI", "8.5882.1234.2111", "nonsense"):
        yield ["devices", "--label", label]


def words(devices):
    for device in devices:
        serial = device.startswith("kuebler-esc")
        for direction in ("in", "out"):
            for word in REQUESTS if serial else WORDS:
                yield ["explain", word, "--device", device, "--direction", direction]
    for mode in ("position", "cam", "velocity"):
        for word in WORDS:
            yield ["explain", word, "--device", "fraba-ocd-ib", "--direction", "in", "--mode", mode, "--other",
                   "20210001", "--coding", "3"]


def looking():
    yield ["scan"]
    yield ["doctor"]
    for place in PLACES:
        yield ["read", place]
        yield ["read", place, "steps"]
        yield ["read", place, "serial-number", "--trace"]
        yield ["monitor", place, "--for", "1"]
        yield ["restore", place, "--list"]
    yield ["monitor", "2.0", "--for", "2", "--every", "500"]
    yield ["gateway", "1.0"]
    for request in REQUESTS:
        yield ["terminal", request, "--yes"]


def writing():
    ledger = ["--ledger", "writes.sqlite"]
    for place in PLACES:
        for parameter in PARAMETERS:
            yield ["write", place, f"{parameter}=1", "--dry-run"]
            yield ["write", place, f"{parameter}=1", "--yes", "--trace"]
        yield ["write", place, "steps=255", "--yes", *ledger]
        yield ["write", place, "steps=4096", "revolutions=16", "direction=cw", "preset=0", "--yes", "--trace", *ledger]
        yield ["write", place, "steps=0", "--yes"]
        yield ["write", place, "steps=99999999999", "--yes"]
        yield ["write", place, "steps=1.000", "--yes"]
        yield ["write", place, "steps=4096"]
        yield ["restore", place, *ledger, "--dry-run"]
    for words_sent in (["020000FF", "04000001", "06000003", "08000000", "80000000", "00000000"], ["7F000000"],
                       ["00000000"], ["XYZ"]):
        for place in RING:
            yield ["words", place, *words_sent, "--yes", *ledger]


def functions():
    ledger = ["--ledger", "functions.sqlite"]
    for place in PLACES:
        yield ["preset", place, "--yes", "--trace", *ledger]
        yield ["preset", place, "1000", "--yes", "--trace", *ledger]
        yield ["preset", place, "1000", "--fraba", "--yes", *ledger]
        yield ["velocity", place, "on", "--trace", *ledger]
        yield ["velocity", place, "off", *ledger]
        yield ["reset", place, "--yes", "--trace", *ledger]
        yield ["reset", place]
        yield ["cams", place, "read", f"cams-of-{place}.json", *ledger]
        yield ["cams", place, "compare", "cams.json", *ledger]
        yield ["cams", place, "write", "cams.json", "--yes", "--trace", *ledger]


def projects():
    ledger = ["--ledger", "projects.sqlite"]
    for project in ("crane", "training", "two-encoders"):
        file = f"{project}.codewheel"
        yield ["compare", file]
        yield ["transfer", file, "--dry-run", *ledger]
        yield ["report", file, "-o", f"{project}.html", *ledger]
        yield ["read", "1.0", "--project", file]
    yield ["store", "stored.codewheel"]
    yield ["store", "stored-with-cams.codewheel", "--cams", "--trace"]
    yield ["scan", "--save", "scanned.codewheel"]
    yield ["compare", "stored.codewheel"]
    yield ["transfer", "training.codewheel", "--yes", "--trace", "--report", "transfer.html", *ledger]
    yield ["transfer", "stored.codewheel", "--stored", "--yes", *ledger]
    for start in ("1.0", "5.0", "05"):
        for end in ("6.1", "2.0", "12"):
            yield ["clone", start, end, "--dry-run"]
            yield ["clone", start, end, "--yes", *ledger]
    for place in PLACES:
        yield ["replace", place, "--project", "training.codewheel", "--dry-run"]
        yield ["replace", place, "--project", "training.codewheel", "--position", "100", "--yes", "--report",
               f"replace-{place}.html", *ledger]
    yield ["report", "stored.codewheel", "-o", "stored.html", "--read", "--yes", *ledger]


def recordings():
    yield ["record", "-o", "all.cwrec", "--for", "2"]
    yield ["record", "1.0", "05", "-o", "two.cwrec", "--for", "1", "--no-traffic"]
    yield ["record", "2.0", "-o", "trigger.cwrec", "--trigger", "2.0/in.10=1", "--before", "1", "--after", "1"]
    for name in ("all", "two", "trigger"):
        yield ["export", f"{name}.cwrec"]
        yield ["export", f"{name}.cwrec", "-o", f"{name}.csv"]
        yield ["export", f"{name}.cwrec", "-o", f"{name}-turns.csv", "--unit", "turns", "--locale"]
    yield ["export", "all.cwrec", "-o", "some.csv", "--tracks", "2.0/position,2.0/speed,1.0/in.25", "--from", "+1",
           "--dates"]
    yield ["frames", "commissioning.log"]
    yield ["frames", "commissioning.log", "--times", "differences"]


def ledgers():
    for file in ("writes", "functions", "projects"):
        yield ["ledger", "--ledger", f"{file}.sqlite"]
        yield ["ledger", "entries", "--ledger", f"{file}.sqlite"]
        yield ["ledger", "export", f"{file}.json", "--ledger", f"{file}.sqlite"]
    yield ["ledger", "import", "writes.json", "functions.json", "--ledger", "all.sqlite"]
    yield ["messages"]
    yield ["messages", "--last", "5", "--severity", "fault"]


def masters():
    for what in (["status"], ["start"], ["stop"], ["alarm-stop"], ["read-in"], ["confirm"], ["segment", "6", "off"],
                 ["segment", "6", "on"], ["segment", "9", "off"]):
        yield ["master", *what, "--yes"]
        yield ["master", *what, "--yes", "--after", "31000", "--fault-plan", "faults.json"]
    for place in PLACES:
        yield ["read", place, "--fault-plan", "faults.json"]
        yield ["write", place, "steps=255", "--yes", "--fault-plan", "faults.json"]


def can_buses():
    """On the simulated CAN bus alone, and in a log."""
    for call in (["scan"], ["scan", "--ask"], ["lss", "scan"], ["lss", "show", "--of", "can:6"], ["lss", "node", "9", "--yes"],
                 ["lss", "node", "5", "--yes"], ["lss", "rate", "250000", "--of", "can:6", "--yes"],
                 ["lss", "store", "--of", "can:6", "--yes"], ["nmt", "start", "--yes"]):
        yield [*call, "--link", "canopen:training"]
    for name in ("whole.dcf", "compact.eds", "odd.eds", "encoder.eds"):
        yield ["devices", "--check", name]
        yield ["eds", name, "--compare", "whole.dcf"]
        yield ["eds", name, "--read", "can:6", "--link", "canopen:training"]
    for place in ("can:5", "can:6", "can:7", "can:50"):
        for call in (["read", place], ["read", place, "serial-number", "--trace"], ["monitor", place, "--for", "1"],
                     ["write", place, "steps=4096", "--yes"], ["preset", place, "1000"], ["reset", place, "--yes"],
                     ["cams", place, "read"], ["od", place], ["od", place, "read", "6004"], ["od", place, "read", "1008"],
                     ["od", place, "write", "6001=4096", "--yes"], ["od", place, "write", "1010:1=save", "--yes"],
                     ["nmt", "start", place, "--yes"], ["nmt", "reset", place, "--yes"]):
            yield [*call, "--link", "canopen:training"]
    yield ["reset", "can:5", "--yes", "--link", "canopen:training,may-stop=yes"]


def refused(commands):
    yield ["nonsense"]
    for command in commands:
        if command not in ("devices", "scan", "find", "doctor", "messages", "serve", "terminal", "master", "ledger"):
            yield [command]
        yield [command, "--nonsense"]
    for place in ("9.9", "7.0", "FF", "00", "nowhere", "Ring/1.0", "Line/05", "6.0", "esc:05", ""):
        yield ["read", place]
        yield ["write", place, "steps=255", "--yes"]
    for link in ("nonsense", "esc:no-such-port", "modbus-tcp:127.0.0.1:1", "project"):
        yield ["read", "1.0", "--link", link]
    for project in ("none.codewheel", "cams.json", "faults.json"):
        yield ["compare", project]
    yield ["cams", "1.0", "write", "crane.codewheel", "--yes"]
    yield ["export", "crane.codewheel"]
    yield ["restore", "1.0", "--at", "yesterday"]
    yield ["ledger", "carry", "x"]
