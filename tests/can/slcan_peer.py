#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""An SLCAN adapter behind a pseudo terminal, for tests of whatever speaks to one.

Written from Lawicel's manuals and from what other firmwares are known to do; it shares no code with the program. It
prints the path of the terminal as its first line. Then each line of its standard input is an order, and is answered
with lines that end with "ok":

  bus FRAME     another node sends it; frames are as candump logs them: 185#8813, 0CFFE0E0#, 705#R1
  heard         prints the frames that the adapter has put on the bus since the last time
  state         prints closed, open or listening, the rate command, and "!" if it was ever open to send
  hold, go      answers wait, or do not any more
  raw HEX       these bytes come from the adapter
  status HEX    of F from now on
  reset         the board starts anew

It ends with its standard input, which is how the adapter is unplugged.
"""

import argparse
import os
import select
import sys
import time
import tty

BELL = b"\a"
BOOT_TEXT = b"CAN BUS Shield\r\ninit ok!\r\n"


class Adapter:
    def __init__(self, options):
        self.options = options
        self.state = "closed"
        self.rate = ""
        self.was_open = False
        self.stamps = False
        self.status = "00"
        self.command = b""
        self.heard = []
        self.hears_from = 0.0  # a board that starts hears nothing before
        self.boots_at = None
        self.is_held = False
        self.held = b""
        self.due = []  # (time, bytes)
        self.was_touched = False
        self.master, self.slave = os.openpty()
        tty.setraw(self.slave)
        if options.open:
            self.state = "open"

    # To the program.

    def put(self, data):
        pieces = [data[i:i + 1] for i in range(len(data))] if self.options.tear else [data]
        for piece in pieces:
            os.write(self.master, piece)
            if self.options.tear:
                time.sleep(0.0005)

    def answer(self, data):
        if self.is_held:
            self.held += data
        elif self.options.late:
            self.due.append((time.monotonic() + self.options.late / 1e3, data))
        else:
            self.put(data)

    def end_of_line(self):
        return {"cr": b"\r", "lf": b"\n", "crlf": b"\r\n"}[self.options.end]

    def receive(self, frame):
        """A frame from the bus."""
        if self.state == "closed":
            return
        identifier, data = frame.split("#")
        is_extended = len(identifier) == 8
        if data.startswith("R"):
            line = ("R" if is_extended else "r") + identifier + (data[1:] or "0")
        else:
            line = ("T" if is_extended else "t") + identifier + str(len(data) // 2) + data
        if self.stamps or self.options.stamps:
            line += f"{int(time.monotonic() * 1000) % 60000:04X}"
        self.put(line.encode() + self.end_of_line())

    # From the program.

    def hear(self, data):
        now = time.monotonic()
        if self.options.boot and not self.was_touched:
            self.was_touched = True  # as by DTR
            self.start_anew(self.options.boot / 1e3)
        for byte in data:
            if now < self.hears_from:
                continue
            if byte == 0x0D:
                command, self.command = self.command, b""
                reply = self.reply(command.decode("latin-1"))
                if reply is not None:
                    self.answer(reply)
            else:
                self.command += bytes([byte])

    def start_anew(self, seconds):
        self.state, self.rate, self.command = "closed", "", b""
        self.hears_from = time.monotonic() + seconds
        self.boots_at = self.hears_from

    def transmit(self, text):
        size = 8 if text[0] in "TR" else 3
        identifier, length, data = text[1:1 + size], text[1 + size:2 + size], text[2 + size:]
        if text[0] in "rR":
            self.heard.append(f"{identifier}#R{length}")
        else:
            self.heard.append(f"{identifier}#{data}")
            assert len(data) == 2 * int(length), text

    def reply(self, text):
        letter = text[:1]
        done = self.end_of_line()
        silent = self.options.firmware == "canable"
        if letter == "V" and len(text) == 1:
            versions = {"lawicel": b"V1013", "canable": b"CANable-b158aa7 github.com", "uccb": b"V1.4 UCCB",
                        "arduino": b"V1.0"}
            return versions[self.options.firmware] + done
        if silent:
            self.carry_out(text)
            return None
        if letter == "F" and self.options.firmware == "lawicel":
            return f"F{self.status}".encode() + done
        return (b"z" if letter in "tr" else b"Z" if letter in "TR" else b"") + done if self.carry_out(text) else BELL

    def carry_out(self, text):
        """Whether it could be."""
        letter = text[:1]
        if letter == "S" and len(text) == 2 and text[1] in "012345678":
            if self.state != "closed" or text[1] in self.options.no_rates:
                return False
            self.rate = text
        elif text == "O" and self.state == "closed" and self.rate:
            self.state, self.was_open = "open", True
        elif text == "L" and self.state == "closed" and self.rate and not self.options.no_listening:
            if self.options.firmware == "canable":
                return False
            self.state = "listening"
        elif text == "C" and self.state != "closed":
            self.state = "closed"
        elif letter and letter in "tTrR" and self.state == "open":
            self.transmit(text)
        else:
            return False
        return True

    # From the test.

    def obey(self, order):
        word, _, rest = order.partition(" ")
        if word == "bus":
            self.receive(rest)
        elif word == "heard":
            for frame in self.heard:
                print(frame)
            self.heard = []
        elif word == "state":
            print(self.state, self.rate, "!" if self.was_open else "")
        elif word == "hold":
            self.is_held = True
        elif word == "go":
            self.is_held = False
            self.put(self.held)
            self.held = b""
        elif word == "raw":
            self.put(bytes.fromhex(rest))
        elif word == "status":
            self.status = rest
        elif word == "reset":
            self.start_anew(0.05)
        print("ok", flush=True)

    def tick(self):
        """What is due; returns the time until the next."""
        now = time.monotonic()
        while self.due and self.due[0][0] <= now:
            self.put(self.due.pop(0)[1])
        if self.boots_at is not None and self.boots_at <= now:
            self.boots_at = None
            self.put(BOOT_TEXT)
        times = [at for at, _ in self.due[:1]] + ([self.boots_at] if self.boots_at is not None else [])
        return max(0.0, min(times) - now) if times else None

    def serve(self):
        print(os.ttyname(self.slave), flush=True)
        orders = b""
        while True:
            ready, _, _ = select.select([self.master, sys.stdin], [], [], self.tick())
            if self.master in ready:
                self.hear(os.read(self.master, 1000))
            if sys.stdin in ready:
                more = os.read(sys.stdin.fileno(), 4096)
                if not more:
                    return
                orders += more
                while b"\n" in orders:
                    order, orders = orders.split(b"\n", 1)
                    self.take_all()
                    self.obey(order.decode())

    def take_all(self):
        """What the program wrote before the order is carried out first."""
        while select.select([self.master], [], [], 0)[0]:
            self.hear(os.read(self.master, 1000))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--firmware", choices=["lawicel", "canable", "uccb", "arduino"], default="lawicel")
    parser.add_argument("--end", choices=["cr", "lf", "crlf"], default="cr", help="of its lines")
    parser.add_argument("--tear", action="store_true", help="every byte by itself")
    parser.add_argument("--late", type=float, default=0, help="ms before each answer")
    parser.add_argument("--boot", type=float, default=0, help="ms that the board needs to start when it is opened")
    parser.add_argument("--open", action="store_true", help="it was left open")
    parser.add_argument("--stamps", action="store_true", help="frames have ms from the beginning")
    parser.add_argument("--no-listening", action="store_true", help="L is refused")
    parser.add_argument("--no-rates", default="", help="digits of S that are refused")
    Adapter(parser.parse_args()).serve()


if __name__ == "__main__":
    main()
