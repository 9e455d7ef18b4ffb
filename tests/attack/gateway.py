# SPDX-License-Identifier: GPL-3.0-or-later
"""A ring behind a gateway whose network is bad: what a command claims is compared with what the encoder has.

The program offers its training ring itself; between it and the commands is the relay of gateway_relay.py. When a command
has ended, the encoder is asked on a connection without the relay. The server does not tell how often the EEPROM was
written. But all words pass the relay, which lets each of them stand until the encoder has acted on it: so each write is
seen, and the ledger has to count neither more, nor fewer with those that it counts as "perhaps".
"""

import shutil
import time
from random import Random

import ledger
from gateway_relay import FAIR, Relay, Weather
from gateway_ring import PRESET, READ_OUT, RUN, Ring, has_crashed

WEATHERS = (FAIR, Weather(0, 0, 0.5), Weather(0, 0.3, 0.3), Weather(0.01, 0.02, 0.4), Weather(0.03, 0.1, 0.3),
            Weather(0.1, 0.1, 0.1), Weather(0.3, 0.3, 0.3))
LINKS = ("", "", ",time-out=150", ",time-out=100,retries=1", ",interval=0,time-out=200", ",write=23,in-area=holding,in=4096",
         ",read-back=off", ",status=8192,run-bit=5,place=8193")
COMMANDS_OF_A_RING = 40  # more would wear its EEPROM out, which is asked about
CHANGED_BY_PARAMETERS = ("steps", "revolutions", "direction", "preset")
OTHERS = (RUN, 0x02000000, READ_OUT | 1)  # words that stand at the other devices, and change nothing


class Attempt:
    """One command, and what was true before and after it."""

    def __init__(self, ring, relay, before, findings):
        self.before = before
        self.pending = dict(ring.account.pending)  # what earlier commands have left, to be valid after the next run
        self.out_before = ring.out()
        self.shown_before = ring.account.shown()
        self._ring = ring
        self._relay = relay
        self._findings = findings

    def ended(self, run):
        self.run = run
        self.answer = run.answer()
        self.out = self._ring.out()
        self.pending_after = dict(self._ring.account.pending)
        self.not_confirmed = self._ring.account.not_confirmed
        self.is_in_operation = self._ring.account.is_in_operation()
        self.requests_that_write = self._relay.writes
        self.after = self._ring.truth()

    def is_done(self):
        return self.run.code == 0

    def reads_back(self):
        return not any("read-back=off" in argument for argument in self.run.arguments)

    def leaves_a_word(self):
        """In OUT, of which it does not say that it may be there."""
        left = self.out[0]
        return left not in (0, self.out_before[0]) and f"{left:08X}" not in self.doubt().get("out", [])

    def doubt(self):
        """What is told of it; {} if nothing is."""
        return self.answer.get("inDoubt", {})

    def told(self, *lists):
        """Pairs of a parameter and its value."""
        return {(one["parameter"], one["value"]) for name in lists for one in self.answer.get(name, [])}

    def named(self):
        """The values that the encoder may have by this answer."""
        doubtful = {(one["parameter"], one["value"]) for one in self.doubt().get("values", [])}
        return self.told("written", "alreadyThere") | doubtful

    def loses(self, sentence):
        told = " ".join(self.run.out.decode(errors="replace").split())
        self._findings.loses(
            f"{sentence}: {self.run}; before {self.before}, pending {self.pending}, OUT {words(self.out_before)}; "
            f"after {self.after}, pending {self.pending_after}, OUT {words(self.out)}; faults: {self._relay.last()}; {told}")


def words(out):
    return " ".join(f"{word:08X}" for word in out)


def write(random):
    """Values that fit together, whatever the others are."""
    values = [f"steps={random.randint(255, 8000)}"]
    values += [f"revolutions={random.randint(1, 4)}"] if random.random() < 0.3 else []
    values += [f"direction={random.choice(('cw', 'ccw'))}"] if random.random() < 0.3 else []
    random.shuffle(values)
    return ("write", "1.0", *values, *(("--all",) if random.random() < 0.5 else ()), "--yes")


def preset(random):
    value = (str(random.randint(0, 100_000)),) if random.random() < 0.8 else ()
    return ("preset", "1.0", *value, "--in-position-mode", "--yes")


def read(random):
    names = random.choice(((), ("serial-number", "steps"), ("steps",)))
    return ("read", "1.0", *names)


def monitor(_):
    return ("monitor", "1.0", "--for", "1")


def alarm_stop(_):
    return ("master", "alarm-stop", "--patience", "3")


def check_answer(attempt):
    """Exit code 0 or 1, a sentence with the latter, JSON, and no report of a crash."""
    run = attempt.run
    if run.code not in (0, 1) or has_crashed(run.err):
        attempt.loses("crashed, hung, or bad input")
    elif attempt.answer.get("exit") != run.code:
        attempt.loses("no JSON, or another exit code in it")
    elif run.code == 1 and not (run.err and "error" in attempt.answer):
        attempt.loses("without a sentence")


def check_values(attempt):
    """What is told is true, and what is new was named."""
    for name, value in attempt.told("written", "alreadyThere", "values"):
        if attempt.after.get(name, value) != value:
            attempt.loses(f"{name} is told as {value}")
    for name in CHANGED_BY_PARAMETERS:
        value = attempt.after[name]
        if value != attempt.before[name] and (name, value) not in attempt.named():
            attempt.loses(f"{name} became {value}, and nothing said so")


def check_write(attempt):
    if not attempt.is_done():
        return
    for one in attempt.answer["plan"]:
        if attempt.after[one["parameter"]] != one["value"]:
            attempt.loses(f"{one['parameter']} was to be {one['value']}")
    check_all_is_over(attempt)


def check_preset(attempt):
    wanted = attempt.run.arguments[2]
    if attempt.is_done():
        value = int(wanted) if wanted.isdigit() else attempt.before["preset"]
        stood_there = attempt.before["position"] == value  # and may be a speed, for all that was seen of it
        told = {value, None} if stood_there else {value}
        if not attempt.after["position"] == attempt.after["preset"] == value or attempt.answer["positionAfter"] not in told:
            attempt.loses(f"position and preset were to be {value}")
        check_all_is_over(attempt)
    elif attempt.after["zero-offset"] != attempt.before["zero-offset"]:
        is_told = attempt.doubt().get("position") or attempt.answer.get("positionAfter") == attempt.after["position"]
        if not is_told:
            attempt.loses("the position was set, and nothing said so")


def check_read(attempt):
    if attempt.is_done():
        check_all_is_over(attempt)
    check_nothing_changed(attempt)


def check_monitor(attempt):
    if attempt.requests_that_write > 0:
        attempt.loses("a monitor has written")
    samples = attempt.answer.get("samples", [])
    if attempt.is_done() and not samples:
        attempt.loses("nothing was seen")
    out, shown = f"{attempt.out_before[0]:08X}", f"{attempt.shown_before:08X}"
    for row in samples:
        expected = out if attempt.reads_back() else None
        if row["in"] != shown or row["out"] != expected:
            attempt.loses(f"OUT {row['out']} and IN {row['in']} were not there, but {out} and {shown}")
    check_nothing_changed(attempt)


def check_alarm_stop(attempt):
    if attempt.is_done() and any(attempt.out):
        attempt.loses("not all of OUT is 0")
    check_nothing_changed(attempt)


def check_all_is_over(attempt):
    if attempt.out[0] or attempt.pending_after or not attempt.is_in_operation:
        attempt.loses("told as done, and the encoder is not in operation with OUT 0")


def check_nothing_changed(attempt):
    if attempt.after != attempt.before:
        attempt.loses("something was changed")


def check_confirmed(attempt):
    """All values are possible ones, and the words have stood long enough."""
    if attempt.not_confirmed:
        attempt.loses(f"the encoder did not confirm {words(attempt.not_confirmed)}")


def check_others(attempt):
    """Only an alarm-stop writes to the other devices, and only 0."""
    is_stop = attempt.run.arguments[1] == "alarm-stop"
    for before, after in zip(attempt.out_before[1:], attempt.out[1:]):
        if after != before and not (is_stop and after == 0):
            attempt.loses(f"{before:08X} in OUT of another device became {after:08X}")


KINDS = ((write, check_write), (write, check_write), (preset, check_preset), (read, check_read), (monitor, check_monitor),
         (alarm_stop, check_alarm_stop))


class Round:
    """A ring as it is when new, and the account of it."""

    def __init__(self, bench, random, number, ring, relay, findings):
        self._bench = bench
        self._random = random
        self._findings = findings
        self._ring = ring
        self._relay = relay
        self._ledger = bench.path(f"gateway-{number}.sqlite")
        self._project = bench.path("ring.codewheel")
        shutil.copy(bench.example("training.codewheel"), self._project)
        self._truth = ring.truth()
        self._again = None  # what was not done, as somebody tries once more

    def attempt(self):
        kind = self._random.choice(KINDS)
        arguments = kind[0](self._random)
        if self._again and self._random.random() < 0.3:
            kind, arguments = self._again
        self._leave_words()
        attempt = Attempt(self._ring, self._relay, self._truth, self._findings)
        self._relay.begin(self._random.choice(WEATHERS))
        run = self._call(arguments)
        if not self._relay.settle():
            self._findings.loses(f"a connection was not closed by {run}")
        attempt.ended(run)
        self._again = None if attempt.is_done() else (kind, arguments)
        self._count(attempt, kind[0].__name__.replace("_", "-") + "s")
        check_answer(attempt)
        if attempt.answer:
            for check in (check_confirmed, check_values, kind[1], check_others, self._check_ledger):
                check(attempt)
        self._make_valid(attempt)

    def _leave_words(self):
        """In OUT, as commands leave them that did not come to their end."""
        account = self._ring.account
        harmless = (account.parameter_word,) if account.pending else (RUN,) if account.is_armed else (RUN, PRESET)
        own = self._random.choice((0, 0, READ_OUT, READ_OUT | 1, READ_OUT | 10, *harmless))
        self._ring.send(own, *(OTHERS if self._random.random() < 0.5 else (0, 0, 0)))

    def _call(self, arguments):
        link = f"modbus-tcp:127.0.0.1:{self._relay.port}{self._random.choice(LINKS)}"
        counts = ("--ledger", self._ledger) if arguments[0] in ("write", "preset") else ()
        return self._bench.run(*arguments, *counts, "--link", link, "--project", self._project, "--json")

    def _count(self, attempt, what):
        self._findings.tries(f"{what} done" if attempt.is_done() else f"{what} not done")
        if attempt.doubt():
            self._findings.tries(f"{what} in doubt")
        if attempt.leaves_a_word():
            attempt.loses("a word is left in OUT, and nothing said so")

    def _check_ledger(self, attempt):
        if "--ledger" not in attempt.run.arguments or not self._ledger.exists():
            return
        count = ledger.counts(self._bench, self._ledger, self._findings)
        if count and not count[0] <= self._ring.writes() <= sum(count):
            attempt.loses(f"the encoder wrote {self._ring.writes()} times, {count[0]} are counted, {count[1]} perhaps")

    def _make_valid(self, attempt):
        """What an attempt has left, mostly."""
        self._truth = attempt.after
        if attempt.pending_after and self._random.random() < 0.7:
            self._ring.run()
            self._truth = self._ring.truth()


def bad_network(bench, random, until, findings):
    """What is claimed is true, what may be is said to be in doubt, and each EEPROM write is counted."""
    number = 0
    while time.monotonic() < until:
        number += 1
        losses = len(findings.lost)
        with Ring(bench, findings) as ring, Relay(ring, Random(random.random())) as relay:
            one = Round(bench, random, number, ring, relay, findings)
            for _ in range(COMMANDS_OF_A_RING):
                if time.monotonic() < until and len(findings.lost) == losses:  # what follows a loss proves nothing
                    one.attempt()
            findings.tried.update(relay.made)
