# SPDX-License-Identifier: GPL-3.0-or-later
"""CANopen encoders behind a bad adapter on a bad bus: what a command claims is compared with what the node has.

The program offers its simulated bus itself; between its adapter and the commands is the relay of can_relay.py. When a
command has ended, the node is asked without the relay. All frames pass the relay, so each write that began, and each one
to the EEPROM that the node confirmed, is seen.
"""

import time
from random import Random

import gateway
import ledger
from can_bus import OPERATIONAL, PRE_OPERATIONAL, STORE, Bus
from can_relay import FAIR, Relay, Weather

NODE = 6  # multi-turn, class 2
PLACE = f"can:{NODE}"
WEATHERS = (FAIR, Weather(0, 0.5), Weather(0.02, 0.3), Weather(0.05, 0.2), Weather(0.15, 0.15), Weather(0.3, 0.3))
COMMANDS_OF_A_BUS = 30  # more would wear its EEPROM out, which is asked about
OBJECTS = {"steps": 0x6001, "measuring-range": 0x6002, "preset": 0x6003, "6200": 0x6200, "1017": 0x1017}
SETTING = 0x6000  # operating parameters
STATES = {"operation": OPERATIONAL, "waiting": PRE_OPERATIONAL}


class Attempt:
    """One command, and what was true before and after it."""

    def __init__(self, bus, relay, before, findings):
        self.before = before
        self.state_before = bus.account.states[NODE]
        self._sent_before = len(bus.account.sent)
        self._bus = bus
        self._relay = relay
        self._findings = findings

    def ended(self, run):
        self.run = run
        self.answer = run.answer()
        self.sent = [what for node, what in self._bus.account.sent[self._sent_before:] if node == NODE]
        self.state = self._bus.account.states[NODE]
        self.after = truth(self._bus)

    def is_done(self):
        return self.run.code == 0

    def is_fair(self):
        """Nothing happened to any frame, and a node that is only listened to may be heard."""
        mayBeUnheard = self.run.arguments[0] == "monitor" and self.state_before != OPERATIONAL
        return self._relay.last() == "none" and not mayBeUnheard

    def doubt(self):
        return self.answer.get("inDoubt", {})

    def told(self, *lists):
        """Objects with their values."""
        pairs = [(one["parameter"], one["value"]) for name in lists for one in self.answer.get(name, [])]
        return {(OBJECTS[name], value) for name, value in pairs if name in OBJECTS}

    def named(self):
        """The values that the node may have by this answer."""
        doubtful = {(OBJECTS[one["parameter"]], one["value"]) for one in self.doubt().get("values", [])
                    if one["parameter"] in OBJECTS}
        by_hand = {(int(self.answer["index"], 16), self.answer["value"])} if self.answer.get("fate") in POSSIBLE else set()
        return self.told("written", "alreadyThere") | doubtful | by_hand | self._preset_named()

    def _preset_named(self):
        if self.run.arguments[0] != "preset":
            return set()
        is_told = self.is_done() or self.doubt().get("position") or self.answer.get("positionAfter") is not None
        return {(OBJECTS["preset"], int(self.run.arguments[2]))} if is_told else set()

    def loses(self, sentence):
        told = " ".join(self.run.out.decode(errors="replace").split())
        self._findings.loses(f"{sentence}: {self.run}; before {self.before}, state {self.state_before}; after {self.after}, "
                             f"state {self.state}; written: {self.sent}; faults: {self._relay.last()}; {told}")


POSSIBLE = ("readBack", "accepted", "unknown", "other")


def truth(bus):
    return {index: bus.value(NODE, index) for index in (*OBJECTS.values(), SETTING)}


def write(random):
    values = [f"steps={2 ** random.randint(4, 12)}"]
    values += [f"6200={random.randint(10, 1000)}"] if random.random() < 0.4 else []
    values += [f"1017={random.choice((0, 100, 500))}"] if random.random() < 0.3 else []
    random.shuffle(values)
    return ("write", PLACE, *values, *(("--all",) if random.random() < 0.5 else ()), "--yes")


def write_object(random):
    index = random.choice((0x6200, 0x1017, 0x6001))
    return ("od", PLACE, "write", f"{index:X}={random.randint(16, 4000)}", "--yes")


def store(_):
    return ("od", PLACE, "write", f"{STORE:X}:1=save", "--yes")


def preset(random):
    return ("preset", PLACE, str(random.randint(0, 15)), "--yes")


def read_object(random):
    return ("od", PLACE, "read", f"{random.choice((0x6200, 0x1017, 0x6001, 0x6002)):X}")


def read(random):
    return ("read", PLACE, *random.choice(((), ("steps", "6200"), ("serial-number",))))


def monitor(_):
    return ("monitor", PLACE, "--for", "1")


def check_answer(attempt):
    """As of a ring; besides, what nothing has happened to is done."""
    gateway.check_answer(attempt)
    if attempt.run.code == 1 and attempt.is_fair():
        attempt.loses("not done, and nothing went wrong")


def check_values(attempt):
    """What is told is true, and what is new was named."""
    for index, value in attempt.told("written", "alreadyThere", "values"):
        if attempt.after[index] != value:
            attempt.loses(f"{index:X} is told as {value}")
    for index in OBJECTS.values():
        value = attempt.after[index]
        if value != attempt.before[index] and (index, value) not in attempt.named():
            attempt.loses(f"{index:X} became {value}, and nothing said so")


def check_sent_once(attempt):
    """A write is never repeated."""
    for one in {what for what in attempt.sent if what[0] != SETTING}:
        if attempt.sent.count(one) > 1:
            attempt.loses(f"{one[0]:X}:{one[1]} was written {attempt.sent.count(one)} times")


def check_state(attempt):
    """A node that was stopped for it runs again, or the answer says that it does not."""
    left = attempt.answer.get("leftIn")
    mayBeUntold = left == "operation" and attempt.state == attempt.state_before  # it gives its position when it is asked
    if left in STATES and STATES[left] != attempt.state and not mayBeUntold:
        attempt.loses(f"left in {left}, it says")
    if attempt.state != attempt.state_before and (attempt.is_done() or left is None):
        attempt.loses("in another state, and nothing said so")


def check_write(attempt):
    if attempt.is_done():
        for one in attempt.answer["plan"]:
            if attempt.after[OBJECTS[one["parameter"]]] != one["value"]:
                attempt.loses(f"{one['parameter']} was to be {one['value']}")


def check_write_object(attempt):
    index, value = attempt.run.arguments[3].split("=")
    if attempt.is_done() and attempt.after[int(index, 16)] != int(value):
        attempt.loses("told as written")


def check_store(attempt):
    if attempt.is_done() and (STORE, 1) not in attempt.sent:
        attempt.loses("told as stored")


def check_preset(attempt):
    if attempt.is_done() and attempt.after[OBJECTS["preset"]] != int(attempt.run.arguments[2]):
        attempt.loses("the preset was to be another")


def check_only_read(attempt):
    if attempt.sent or attempt.after != attempt.before:
        attempt.loses("something was written")


def check_read_object(attempt):
    check_only_read(attempt)
    index = int(attempt.run.arguments[3], 16)
    if attempt.is_done() and attempt.answer["value"] != attempt.after[index]:
        attempt.loses("another value was there")


KINDS = ((write, check_write), (write, check_write), (write_object, check_write_object), (store, check_store),
         (preset, check_preset), (read_object, check_read_object), (read, check_only_read), (monitor, check_only_read))


class Round:
    """A bus as it is when new, and the account of it."""

    def __init__(self, bench, random, number, bus, relay, findings):
        self._bench = bench
        self._random = random
        self._findings = findings
        self._bus = bus
        self._relay = relay
        self._ledger = bench.path(f"can-{number}.sqlite")
        self._truth = truth(bus)

    def attempt(self):
        kind = self._random.choice(KINDS)
        arguments = kind[0](self._random)
        self._bus.command(self._random.choice((1, 1, 128)), NODE)
        attempt = Attempt(self._bus, self._relay, self._truth, self._findings)
        port = self._relay.begin(self._random.choice(WEATHERS))
        run = self._call(arguments, port)
        self._relay.end()
        attempt.ended(run)
        self._truth = attempt.after
        what = kind[0].__name__.replace("_", "-") + "s"
        self._findings.tries(f"{what} done" if attempt.is_done() else f"{what} not done")
        check_answer(attempt)
        if attempt.answer:
            for check in (check_values, check_sent_once, check_state, kind[1], self._check_ledger):
                check(attempt)

    def _call(self, arguments, port):
        counts = ("--ledger", self._ledger) if "--yes" in arguments else ()
        return self._bench.run(*arguments, *counts, "--link", f"slcan:{port},rate=125000", "--json")

    def _check_ledger(self, attempt):
        if "--ledger" not in attempt.run.arguments or not self._ledger.exists():
            return
        count = ledger.counts(self._bench, self._ledger, self._findings)
        stores = self._bus.account.stores
        if count and not count[0] <= stores <= sum(count):
            attempt.loses(f"the node stored {stores} times, {count[0]} are counted, {count[1]} perhaps")


def bad_adapter(bench, random, until, findings):
    """What is claimed is true, what may be is said to be in doubt, no write goes out twice, and each one is counted."""
    number = 0
    while time.monotonic() < until:
        number += 1
        losses = len(findings.lost)
        with Bus(bench) as bus:
            relay = Relay(bus, Random(random.random()))
            one = Round(bench, random, number, bus, relay, findings)
            for _ in range(COMMANDS_OF_A_BUS):
                if time.monotonic() < until and len(findings.lost) == losses:  # what follows a loss proves nothing
                    one.attempt()
            findings.tried.update(relay.made)
