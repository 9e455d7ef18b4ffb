#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A CANopen encoder behind the SLCAN adapter of tests/can/slcan_peer.py, for tests of whatever speaks to one.

Written from CiA 301 and CiA 406; it shares no code with the program. Orders are those of the adapter, and:

  objects       prints each object that was written, as INDEX:SUB=HEX
"""

import argparse
import os
import signal
import sys
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..", "can"))
import slcan_peer

NODE = 5
HEARTBEAT = 0.1
LSS_RATES = ["S8", "S7", "S6", "S5", "S4", None, "S2", "S1", "S0"]


def u(width, number):
    return number.to_bytes(width, "little")


class Encoder(slcan_peer.Adapter):
    def __init__(self, options):
        super().__init__(options)
        self.objects = {
            (0x1000, 0): u(4, 0x00020196), (0x1008, 0): b"Peer encoder", (0x1017, 0): u(2, 100),
            (0x1010, 1): u(4, 1), (0x1018, 0): u(1, 4), (0x1018, 1): u(4, 0x10D), (0x1018, 2): u(4, 0x25),
            (0x1018, 3): u(4, 0x10000), (0x1018, 4): u(4, 4711), (0x6000, 0): u(2, 0), (0x6001, 0): u(4, 8192),
            (0x6002, 0): u(4, 33554432), (0x6003, 0): u(4, 0), (0x6004, 0): u(4, 5000),
            (0x6503, 0): u(2, 0), (0x6505, 0): u(2, 0),
        }
        self.written = []
        self.nmt = 0x7F
        self.segments = b""
        self.toggle = 0
        self.next_beat = 0.0
        self.own_rate = self.next_rate = "S5"
        self.configures = False

    def send(self, identifier, data):
        if self.rate == self.own_rate:
            self.receive(f"{identifier:03X}#{data.hex().upper()}")

    def transmit(self, text):
        super().transmit(text)
        if self.rate != self.own_rate:
            return
        identifier, data = int(text[1:4], 16), bytes.fromhex(text[5:])
        if identifier == 0x7E5:
            self.configure(data)
        elif identifier == 0 and data[1] in (0, NODE):
            self.heed(data[0])
        elif identifier == 0x600 + NODE and self.nmt != 0x04:
            self.send(0x580 + NODE, self.sdo(data))

    def reply(self, text):
        answer = super().reply(text)
        return None if self.options.alone and text[:1] == "t" else answer

    def configure(self, data):
        """By LSS."""
        command = data[0]
        if command == self.options.unplugged_by:
            os._exit(0)
        if command == 0x04:
            self.configures = data[1] == 1
        elif not self.configures:
            return
        elif 0x5A <= command <= 0x5D:
            self.send(0x7E4, bytes([command]) + self.objects[0x1018, command - 0x59] + bytes(3))
        elif command == 0x5E:
            self.send(0x7E4, bytes([command, NODE]) + bytes(6))
        elif command == 0x13:
            self.next_rate = LSS_RATES[data[2]]
            self.send(0x7E4, bytes([command]) + bytes(7))
        elif command == 0x15:
            self.own_rate = self.next_rate

    def heed(self, number):
        self.nmt = {0x01: 0x05, 0x02: 0x04, 0x80: 0x7F}.get(number, 0x7F)
        if number >= 0x81:
            self.send(0x700 + NODE, b"\0")

    def sdo(self, data):
        command, where = data[0], (int.from_bytes(data[1:3], "little"), data[3])
        if command >> 5 == 3:  # the next segment
            piece, self.segments = self.segments[:7], self.segments[7:]
            head = self.toggle | (7 - len(piece)) << 1 | (0 if self.segments else 1)
            self.toggle ^= 0x10
            return bytes([head]) + piece.ljust(7, b"\0")
        if where not in self.objects:
            return b"\x80" + data[1:4] + u(4, 0x06020000)
        if command >> 5 == 2:
            value = self.objects[where]
            if len(value) <= 4:
                return bytes([0x43 | (4 - len(value)) << 2]) + data[1:4] + value.ljust(4, b"\0")
            self.segments, self.toggle = value, 0
            return b"\x41" + data[1:4] + u(4, len(value))
        if where == self.options.stalls_at:
            self.stall()
        size = 4 - (command >> 2 & 3)
        if where[0] in (0x1018, 0x6004):
            return b"\x80" + data[1:4] + u(4, 0x06010002)
        self.written.append(f"{where[0]:04X}:{where[1]}={data[4:4 + size].hex().upper()}")
        if where[0] != 0x1010:
            self.objects[where] = data[4:4 + size]
        if where[0] == 0x6003:
            self.objects[0x6004, 0] = data[4:4 + size]
        return b"\x60" + data[1:4] + bytes(4)

    def stall(self):
        """Stopped, as by the system, until somebody continues it."""
        self.options.stalls_at = None
        os.kill(os.getpid(), signal.SIGSTOP)

    def obey(self, order):
        if order == "objects":
            for one in self.written:
                print(one)
        super().obey(order)

    def tick(self):
        wait = super().tick()
        now = time.monotonic()
        if self.next_beat <= now:
            self.next_beat = now + HEARTBEAT
            if self.state != "closed":
                self.send(0x700 + NODE, bytes([self.nmt]))
                if self.options.master and not self.options.alone:
                    self.receive("080#")
                if self.nmt == 0x05:
                    self.send(0x180 + NODE, self.objects[0x6004, 0])
        rest = max(0.0, self.next_beat - now)
        return rest if wait is None else min(wait, rest)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--running", action="store_true", help="the node is operational")
    parser.add_argument("--master", action="store_true", help="another master sends SYNC")
    parser.add_argument("--no-listening", action="store_true", help="the adapter refuses L")
    parser.add_argument("--unplugged-by", type=lambda text: int(text, 16), help="this command of LSS")
    parser.add_argument("--stalls-at", type=lambda text: (int(text, 16), 0), help="a write to this object")
    parser.add_argument("--alone", action="store_true", help="nobody acknowledges what the adapter sends")
    parser.add_argument("--firmware", default="lawicel", help="of the adapter")
    options = parser.parse_args()
    for name, value in {"end": "cr", "tear": False, "late": 0, "boot": 0, "open": False,
                        "stamps": False, "no_rates": ""}.items():
        setattr(options, name, value)
    encoder = Encoder(options)
    if options.alone:
        encoder.own_rate, encoder.status = None, "A0"
    encoder.nmt = 0x05 if options.running else 0x7F
    encoder.serve()


if __name__ == "__main__":
    main()
