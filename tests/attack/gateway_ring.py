# SPDX-License-Identifier: GPL-3.0-or-later
"""The training ring as `codewheel-cli serve` offers it, and what can be told of its first encoder from outside."""

import json
import signal
import socket
import struct
import subprocess
import tempfile
import threading
import time

from program import PATIENCE

RUN = 0x80000000
PRESET = 0x40000000
CONFIRMED = 0xC0000000
READ_OUT = 0x20210000
READ_OUT_ANSWER = 0b101  # its first three bits
DATA = 0x01FFFFFF
CODES = {"serial-number": 0, "steps": 1, "revolutions": 2, "direction": 3, "preset": 4, "zero-offset": 5, "preset-flag": 6}
NAMES = {1: "steps", 2: "revolutions", 3: "direction", 4: "preset", 5: "zero-offset"}
OUT_REGISTERS = 8  # of the training ring
STANDING = 0.01  # s, for which a word stays, so that the encoder has acted on it: ten cycles
READ_HOLDING, READ_INPUT, WRITE, WRITE_AND_READ = 3, 4, 16, 23


class Closed(Exception):
    """The other end has closed the connection, or this one is to be closed."""


def receive(line):
    """A whole message of Modbus/TCP."""
    message = _receive(line, 6)
    return message + _receive(line, int.from_bytes(message[4:6], "big"))


def _receive(line, count):
    received = b""
    while len(received) < count:
        part = line.recv(count - len(received))
        if not part:
            raise Closed
        received += part
    return received


def function(message):
    return message[7]


def written(request):
    """The registers of OUT that a request writes from the first one on; empty: none."""
    if function(request) not in (WRITE, WRITE_AND_READ):
        return ()
    first = 8 if function(request) == WRITE else 12
    begin, count = struct.unpack_from(">HH", request, first)
    return struct.unpack_from(f">{count}H", request, first + 5) if begin == 0 else ()


def word_written(request):
    """To the first encoder; None: the request does not write to it."""
    registers = written(request)
    return registers[0] << 16 | registers[1] if len(registers) > 1 else None


def is_parameter(word):
    return word >> 29 == 0 and word >> 25 != 0


class Wire:
    """A connection with the server, without anything in between."""

    def __init__(self, port):
        self._line = socket.create_connection(("127.0.0.1", port), PATIENCE)
        self._line.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self._line.close()

    def pass_on(self, request):
        self._line.sendall(request, socket.MSG_NOSIGNAL)
        return receive(self._line)

    def ask(self, code, body):
        answer = self.pass_on(struct.pack(">HHHBB", 1, 0, len(body) + 2, 1, code) + body)
        if function(answer) != code:
            raise RuntimeError(f"the served ring refuses function {code} with exception {answer[8]}")
        return answer[8:]

    def read(self, code, first, count):
        return struct.unpack_from(f">{count}H", self.ask(code, struct.pack(">HH", first, count)), 1)

    def write(self, first, *registers):
        count = len(registers)
        self.ask(WRITE, struct.pack(f">HHB{count}H", first, count, 2 * count, *registers))


class Account:
    """What the first encoder, a FRABA K3 that stands still, did with the words that went to it.

    A word stays until the encoder has acted on it. So the number of its EEPROM writes is known: one for each parameter
    that it has confirmed, and one for a preset that was programmed and not used up.
    """

    def __init__(self, wire):
        self._wire = wire
        self.word = 0
        self.parameter_word = 0  # the last one
        self.pending = {}  # confirmed, and not valid before run
        self.is_armed = False
        self.writes = 0
        self.not_confirmed = []  # parameter words

    def shown(self):
        high, low = self._wire.read(READ_INPUT, 0, 2)
        return high << 16 | low

    def is_in_operation(self):
        return self.shown() >> 29 == 0

    def see(self, word):
        before, self.word = self.word, word
        if word == before:
            return
        time.sleep(STANDING)
        if is_parameter(word):
            self._see_parameter(word)
        elif word & ~before & RUN:
            self._see_run()
        elif word == PRESET and not before & PRESET and self.is_armed and self.is_in_operation():
            self.writes += 1
            self.is_armed = False

    def _see_parameter(self, word):
        if not self.shows(CONFIRMED | word):
            self.not_confirmed.append(word)
            return
        self.writes += 1
        self.parameter_word = word
        self.pending[NAMES.get(word >> 25)] = word & DATA

    def _see_run(self):
        if self.is_in_operation():
            self.is_armed = self.is_armed or "preset" in self.pending
            self.pending = {}

    def shows(self, word, mask=0xFFFFFFFF):
        return self._comes(lambda shown: shown & mask == word)

    def shows_no_read_out(self):
        return self._comes(lambda shown: shown >> 29 != READ_OUT_ANSWER)

    def _comes(self, is_so):
        until = time.monotonic() + 1
        while not is_so(self.shown()):
            if time.monotonic() > until:
                return False
            time.sleep(0.001)
        return True


class Ring:
    """The server, and a connection of our own. Everything that is written to it goes through here, one after the other."""

    def __init__(self, bench, findings):
        self._findings = findings
        self._err = tempfile.TemporaryFile()
        self._process = subprocess.Popen([str(bench.cli), "serve", "modbus-tcp", "--port", "0", "--json"],
                                         stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=self._err,
                                         env=bench.environment, cwd=bench.folder)
        self.port = 0
        self._lock = threading.Lock()
        self._own_writes = 0  # to the EEPROM, by words of the attack itself

    def __enter__(self):
        try:
            address, _, port = self._process.stdout.readline().decode().strip().rpartition(":")
            if address != "127.0.0.1":
                raise RuntimeError(f"the ring is offered at {address!r}, and not on this computer only")
            self.port = int(port)
            self._wire = Wire(self.port)
            self.account = Account(self._wire)
        except BaseException:
            self.__exit__()
            raise
        return self

    def __exit__(self, *_):
        self._process.send_signal(signal.SIGINT)
        try:
            out, _ = self._process.communicate(timeout=PATIENCE)
        except subprocess.TimeoutExpired:
            self._process.kill()
            out, _ = self._process.communicate()
        with self._err:
            self._err.seek(0)
            err = self._err.read()
        if self._process.returncode != 0 or not is_json(out) or has_crashed(err):
            self._findings.loses(f"the server ended with {self._process.returncode}: {out[-200:]!r} {err[-500:]!r}")

    def writes(self):
        """To the EEPROM of the encoder, by others."""
        return self.account.writes - self._own_writes

    def pass_on(self, wire, request):
        """The answer to a request of somebody else."""
        if not written(request):
            return wire.pass_on(request)
        with self._lock:
            answer = wire.pass_on(request)
            if function(answer) == function(request) and word_written(request) is not None:
                self.account.see(word_written(request))
            return answer

    def out(self):
        """Of all devices, two registers each."""
        registers = self._wire.read(READ_HOLDING, 0, OUT_REGISTERS)
        return [high << 16 | low for high, low in zip(registers[::2], registers[1::2])]

    def send(self, word, *others):
        """To the first encoder, and to those behind it."""
        with self._lock:
            self._wire.write(0, *(register for one in (word, *others) for register in (one >> 16, one & 0xFFFF)))
            before = self.account.writes
            self.account.see(word)
            self._own_writes += self.account.writes - before

    def read_out(self, name):
        self._end_read_out()  # an answer has no number: it must not be that of before
        self.send(READ_OUT | CODES[name])
        if not self.account.shows(READ_OUT_ANSWER << 29, 0xE0000000):
            raise RuntimeError(f"the encoder does not tell its {name}")
        value = self.account.shown() & DATA
        self._end_read_out()
        return value

    def _end_read_out(self):
        self.send(0)
        if not self.account.shows_no_read_out():
            raise RuntimeError("the encoder does not end its read-out")
        time.sleep(STANDING)

    def truth(self):
        """The values of the encoder, and its position; None: it shows none. OUT is 0 afterwards."""
        values = {name: self.read_out(name) for name in CODES}
        shown = self.account.shown()
        values["position"] = shown if shown >> 29 == 0 else None
        if bool(values["preset-flag"]) != self.account.is_armed:
            raise RuntimeError("the account of the encoder is wrong")
        return values

    def run(self):
        """What was confirmed becomes valid."""
        self.send(RUN)
        self.send(0)


def has_crashed(err):
    return any(one in err for one in (b"Sanitizer", b"runtime error:", b"ASSERT", b"terminate called"))


def is_json(out):
    try:
        json.loads(out)
    except ValueError:
        return False
    return True
