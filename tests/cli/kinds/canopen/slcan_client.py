#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A program at the port of an SLCAN adapter, for tests of whatever offers one. It shares no code with the program.

  slcan_client.py PORT WORD...          writes each command, and prints its answer: "S4 -> ok", "t000 -> refused",
                                        "V -> V1013". A WORD "+SECONDS" reads so long, and prints the frames that came.
  slcan_client.py --python-can PORT     asks node 5 for its position with python-can, and prints the answer.
"""

import os
import select
import sys
import termios
import time
import tty

PATIENCE = 30.0


class Port:
    def __init__(self, path):
        self.file = os.open(path, os.O_RDWR | os.O_NOCTTY)
        tty.setraw(self.file, termios.TCSANOW)
        self.rest = b""
        self.frames = []

    def line(self, seconds):
        """The next line, or the bell; None: nothing more came."""
        end = time.monotonic() + seconds
        while True:
            for at, byte in enumerate(self.rest):
                if byte in b"\r\a":
                    line, self.rest = self.rest[:at + 1], self.rest[at + 1:]
                    return line.decode("latin-1")
            left = end - time.monotonic()
            if left <= 0 or not select.select([self.file], [], [], left)[0]:
                return None
            self.rest += os.read(self.file, 4096)

    def ask(self, command):
        os.write(self.file, command.encode() + b"\r")
        while True:
            line = self.line(PATIENCE)
            if line is None:
                return "nothing"
            if line[0] in "tTrR" and len(line) > 1:
                self.frames.append(line[:-1])
            else:
                return {"\r": "ok", "\a": "refused"}.get(line, line[:-1])

    def listen(self, seconds):
        end = time.monotonic() + seconds
        while (line := self.line(end - time.monotonic())) is not None:
            self.frames.append(line[:-1])
        frames, self.frames = self.frames, []
        return frames


def with_python_can(path):
    import can
    with can.interface.Bus(interface="slcan", channel=path, bitrate=125000, sleep_after_open=0) as bus:
        bus.send(can.Message(arbitration_id=0x605, is_extended_id=False, data=[0x40, 4, 0x60, 0, 0, 0, 0, 0]))
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end:
            message = bus.recv(1)
            if message is not None and message.arbitration_id == 0x585:
                print(message.data.hex())
                return


def main():
    if sys.argv[1] == "--python-can":
        with_python_can(sys.argv[2])
        return
    port = Port(sys.argv[1])
    for word in sys.argv[2:]:
        if word.startswith("+"):
            print(*port.listen(float(word[1:])), sep="\n")
        else:
            print(word, "->", port.ask(word))


if __name__ == "__main__":
    main()
