# SPDX-License-Identifier: GPL-3.0-or-later
"""A bad adapter and a bad bus: a relay between a program with a serial port and the served bus behind its SLCAN adapter."""

import collections
import os
import select
import threading
import time
import tty

from can_bus import OPEN, Frame

LONGEST_DELAY = 0.4  # s
LONGEST_STALL = 2.5  # s
BEHIND = "adapters lost behind a request"  # nobody sees what becomes of it


class Weather:
    """How often something happens to a frame, and to one that begins to write."""

    def __init__(self, of_frames, of_writes):
        self.of_frames = of_frames
        self.of_writes = of_writes


FAIR = Weather(0, 0)


class Relay:
    """A new pseudo terminal for each client: an adapter that was lost does not come back."""

    SHOWN = 6  # of the faults that came last

    def __init__(self, bus, random):
        self.bus = bus
        self.random = random
        self.made = collections.Counter()
        self._weather = FAIR
        self._last = collections.deque(maxlen=self.SHOWN)
        self._on_request = {
            "requests lost": self._lose, "requests refused by the adapter": lambda line: self._tell(b"\a"),
            "requests delayed": self._delay_request, "adapters lost before a request": lambda line: self._unplug(),
            BEHIND: self._unplug_behind, "stalls": self._stall}
        self._on_answer = {
            "answers lost": lambda line: None, "answers delayed": self._delay_answer, "answers doubled": lambda line: self._tell(2 * line),
            "answers in pieces": self._in_pieces, "answers cut": self._cut, "answers of another node": self._by_another,
            "adapters lost before an answer": lambda line: self._unplug(), "stray bytes": lambda line: self._tell(b"\xff\x00" + line)}

    def begin(self, weather):
        """The port for the next client."""
        self._weather = weather
        self._last.clear()
        self._to_client = collections.deque()  # with the time from which each is sent
        self._to_bus = collections.deque()
        self._held_until = 0
        self._from_client = b""
        self._master, self._slave = os.openpty()
        tty.setraw(self._slave)
        os.set_blocking(self._master, False)
        self._is_plugged = True
        self._is_over = False
        self._thread = threading.Thread(target=self._run, daemon=True)
        self._thread.start()
        return os.ttyname(self._slave)

    def end(self):
        """Until everything that the client has sent is at the bus or lost, and the nodes have answered."""
        until = time.monotonic() + LONGEST_STALL + 1
        while time.monotonic() < until and (self._to_bus or self.bus.account.is_waiting()):
            time.sleep(0.02)
        time.sleep(0.05)
        self._is_over = True
        self._thread.join()
        self._unplug()
        self.bus.send(OPEN)
        self.bus.pass_over(0.1)

    def last(self):
        return "; ".join(self._last) or "none"

    def _run(self):
        while not self._is_over:
            self._pass_on_in_time()
            ports = [self.bus.port] + ([self._master] if self._is_plugged else [])
            ready = select.select(ports, [], [], 0.005)[0]
            if self._is_plugged and self._master in ready:
                self._take_from_client()
            if self.bus.port in ready:
                for line in self.bus.receive(0):
                    self._carry_answer(line)

    def _pass_on_in_time(self):
        now = time.monotonic()
        while self._to_bus and self._to_bus[0][0] <= now:
            self.bus.send(self._to_bus.popleft()[1])
        while self._to_client and max(self._to_client[0][0], self._held_until) <= now:
            data = self._to_client.popleft()[1]
            if self._is_plugged:
                os.write(self._master, data)

    def _take_from_client(self):
        try:
            self._from_client += os.read(self._master, 65536)
        except OSError:  # nobody has it open
            return
        *lines, self._from_client = self._from_client.split(b"\r")
        for line in lines:
            self._carry_request(line + b"\r")

    def _carry_request(self, line):
        frame = Frame.of(line)
        if frame and self._is_plugged and self._strikes(frame):
            is_worst = frame.begins_write() and self.random.random() < 0.3
            kind = BEHIND if is_worst else self.random.choice(list(self._on_request))
            self._note(kind, frame)
            self._on_request[kind](line)
        else:
            self._send(line)

    def _carry_answer(self, line):
        frame = Frame.of(line)
        if frame and frame.is_answer() and self._is_plugged and self._strikes(frame):
            kind = self.random.choice(list(self._on_answer))
            self._note(kind, frame)
            self._on_answer[kind](line)
        else:
            self._tell(line)

    def _strikes(self, frame):
        is_of_write = frame.begins_write() or (frame.is_answer() and frame.specifier() == 3)
        return self.random.random() < (self._weather.of_writes if is_of_write else self._weather.of_frames)

    def _note(self, kind, frame):
        self.made[kind] += 1
        self._last.append(f"{kind} ({frame.line().decode().strip()})")

    def _send(self, line, after=0.0):
        before = self._to_bus[-1][0] if self._to_bus else 0
        self._to_bus.append((max(before, time.monotonic() + after), line))

    def _tell(self, data, after=0.0):
        before = self._to_client[-1][0] if self._to_client else 0
        self._to_client.append((max(before, time.monotonic() + after), data))

    def _lose(self, _):
        self._tell(b"z\r")  # the adapter has sent it, as far as it knows

    def _delay_request(self, line):
        self._send(line, self.random.uniform(0, LONGEST_DELAY))

    def _delay_answer(self, line):
        self._tell(line, self.random.uniform(0, LONGEST_DELAY))

    def _in_pieces(self, line):
        cut = self.random.randint(1, len(line) - 1)
        self._tell(line[:cut])
        self._tell(line[cut:], self.random.uniform(0, 0.1))

    def _cut(self, line):
        self._tell(line[:self.random.randint(1, len(line) - 2)] + b"\r")

    def _by_another(self, line):
        frame = Frame.of(line)
        wrong = bytes([*frame.data[:4], *(octet ^ 0x55 for octet in frame.data[4:])])
        self._tell(Frame(frame.identifier ^ 1, wrong).line() + line)

    def _stall(self, line):
        self._held_until = time.monotonic() + self.random.uniform(0.3, LONGEST_STALL)
        self._send(line)

    def _unplug(self):
        if self._is_plugged:
            self._is_plugged = False
            os.close(self._slave)
            os.close(self._master)

    def _unplug_behind(self, line):
        self._send(line)
        self._unplug()
