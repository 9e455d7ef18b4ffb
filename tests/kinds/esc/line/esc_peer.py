#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Encoders with the Kübler ESC protocol behind a pseudo terminal, for tests of whatever speaks to them.

Written from the manual alone; it shares no code with the program. It prints the path of the terminal as its
first line, then serves until its standard input is closed. Numbers of options are decimal, addresses are as
on the wire: "12" is 12h.
"""

import argparse
import os
import random
import select
import sys
import termios
import time
import tty

ESC = 0x1B
MASTER_ADDRESS = 0
FULL_RANGE = 33554432

# Command: digits of the answer, value as delivered.
READS = {
    "O": (4, 0x2000), "M": (8, FULL_RANGE), "D": (4, 8192), "S": (8, 1), "A": (4, 0), "E": (4, 0x8000),
    "T": (8, 12876), "C": (8, 0), "N": (8, 0), "H": (8, FULL_RANGE - 1), "L": (8, 1), "F": (8, 0x20000000),
    "B": (4, 0x8000), "U": (4, 4096), "P": (8, 0),
}
# Command: digits of the data, least, most, the read that shows it.
WRITES = {
    "GP": (8, 1, FULL_RANGE - 1, "S"), "GR": (8, 1, 8192, "D"), "GM": (4, 1, 4096, "U"),
    "GT": (8, 1, FULL_RANGE - 1, "M"), "GL": (8, 1, FULL_RANGE - 1, "L"), "GH": (8, 1, FULL_RANGE - 1, "H"),
    "GF": (8, 1, 0x20000000, "F"), "GD": (1, 0, 1, None), "GS": (1, 0, 1, None), "X": (2, 1, 31, None),
    "Y": (1, 0, 2, None),
}
OPERATING_BITS = {"GD": 0x0001, "GS": 0x0004}


class Encoder:
    def __init__(self, address, position, speed, ignores):
        self.address = address
        self.ignores = ignores  # commands that are accepted but do nothing
        self.start = position
        self.speed = speed  # steps per second
        self.values = {command: value for command, (_, value) in READS.items()}
        self.values["N"] = 0x12D500 + address

    def position(self):
        return (self.start + int(self.speed * time.monotonic()) + self.values["C"]) % FULL_RANGE

    def answer(self, text):
        letters = text[:2] if text.startswith("G") else text[:1]
        data = text[len(letters):]
        if letters in ("", "G"):
            return "05"
        if letters == "V":
            return "\r\n5882 PEER FOR TESTS V1.00"
        if letters in READS:
            digits = READS[letters][0]
            value = self.position() if letters == "P" else self.values[letters]
            return "05" if data else f"\r\n{value:0{digits}X}"
        if letters in WRITES:
            return self.write(letters, data)
        return "03"

    def write(self, letters, data):
        digits, least, most, shown_by = WRITES[letters]
        if len(data) != digits or not all(c in "0123456789ABCDEFabcdef" for c in data):
            return "05"
        value = int(data, 16)
        if not least <= value <= most:
            return "05"
        if letters in self.ignores:
            return ""
        if letters == "GP":
            self.values["C"] = (value - self.position() + self.values["C"]) % FULL_RANGE
        elif letters == "X":
            self.address = value
        if letters in OPERATING_BITS:
            bit = OPERATING_BITS[letters]
            self.values["O"] = self.values["O"] & ~bit | (bit if value else 0)
        if shown_by:
            self.values[shown_by] = value
        return ""


class Line:
    def __init__(self, options):
        self.options = options
        self.random = random.Random(options.seed)
        self.encoders = [Encoder(int(address, 16), 0x1235 if address == "05" else 1000000, options.speed,
                                 options.ignores.split(","))
                         for address in options.addresses.split(",")]
        for encoder in self.encoders:
            encoder.values["E"] = options.warnings
        self.master, self.slave = os.openpty()  # the slave is kept open, so that clients may come and go
        tty.setraw(self.slave)
        self.request = None

    def noise(self, count):
        return bytes(self.random.randrange(0x80, 0x100) for _ in range(count))

    def junk(self):
        return self.noise(self.options.garbage)

    def is_at_its_rate(self):
        """Whether the program has set the terminal to the rate that the encoders have."""
        rates = termios.tcgetattr(self.slave)[4:6]
        return not self.options.baud or rates == 2 * [getattr(termios, f"B{self.options.baud}")]

    def answer_to(self, request):
        """The bytes on the line in answer to the text between ESC and CR LF."""
        try:
            address = int(request[:2], 16)
        except ValueError:
            return b""
        asked = [each for each in self.encoders if address in (MASTER_ADDRESS, each.address)]
        silent = [int(each, 16) for each in self.options.silent.split(",") if each]
        answers = [each.answer(request[2:]) for each in asked if each.address not in silent]
        if not answers:
            return b""
        if len(answers) > 1:  # they collide
            return self.noise(12)
        answer = answers[0].encode() + b"\r\n"
        if not self.is_at_its_rate():
            return self.noise(self.options.stray)
        return self.junk() + answer + self.junk()

    def hear(self, byte):
        """The request that this byte completes, or None."""
        if byte == ESC:
            self.request = b""
        elif self.request is not None:
            self.request += bytes([byte])
            if self.request.endswith(b"\r\n"):
                text, self.request = self.request[:-2], None
                return text.decode("latin-1")
        return None

    def send(self, data, at):
        """Byte by byte if the line keeps its timing; returns when the last one is out."""
        if self.options.byte_time == 0:
            os.write(self.master, data)
            return
        for i, byte in enumerate(data):
            time.sleep(max(0.0, at + (i + 1) * self.options.byte_time / 1e6 - time.monotonic()))
            os.write(self.master, bytes([byte]))

    def serve(self):
        print(os.ttyname(self.slave), flush=True)
        while True:
            ready, _, _ = select.select([self.master, sys.stdin], [], [])
            if sys.stdin in ready and not os.read(sys.stdin.fileno(), 100):
                return
            if self.master not in ready:
                continue
            received = os.read(self.master, 1000)
            ended = time.monotonic() + len(received) * self.options.byte_time / 1e6
            if self.options.echo:
                self.send(received, time.monotonic())
            for byte in received:
                request = self.hear(byte)
                if request is not None:
                    self.reply(request, ended)

    def reply(self, request, ended):
        answer = self.answer_to(request)
        begin = ended + self.options.delay / 1e3
        time.sleep(max(0.0, begin - time.monotonic()))
        if answer:
            self.send(answer, begin)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--addresses", default="03,05,12", help="of the encoders (03,05,12)")
    parser.add_argument("--speed", type=float, default=0, help="of all shafts in steps a second (0)")
    parser.add_argument("--echo", action="store_true", help="send back what comes in, as a half-duplex adapter")
    parser.add_argument("--garbage", type=int, default=0, help="so many bytes of it before and after an answer")
    parser.add_argument("--silent", default="", help="addresses that do not answer")
    parser.add_argument("--ignores", default="", help="commands that are accepted and do nothing: GP,GR")
    parser.add_argument("--delay", type=float, default=0, help="ms before an answer (0)")
    parser.add_argument("--byte-time", type=float, default=0, help="us for a byte; 573 is 19200 Bd 8N2 (0)")
    parser.add_argument("--warnings", type=lambda digits: int(digits, 16), default=READS["E"][1],
                        help="of all encoders, hexadecimal (8000)")
    parser.add_argument("--baud", type=int, default=0,
                        help="of the encoders; set to any other, the line has no answers (0: they have every rate)")
    parser.add_argument("--stray", type=int, default=0, help="so many bytes of garbage instead of such an answer (0)")
    parser.add_argument("--seed", type=int, default=1, help="of the garbage (1)")
    Line(parser.parse_args()).serve()


if __name__ == "__main__":
    main()
