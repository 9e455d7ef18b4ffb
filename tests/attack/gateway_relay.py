# SPDX-License-Identifier: GPL-3.0-or-later
"""A bad network: a relay between a client of Modbus/TCP and a served ring, both on this computer."""

import collections
import contextlib
import socket
import struct
import threading
import time

from gateway_ring import PRESET, RUN, Closed, Wire, function, is_parameter, receive, word_written

LONGEST_DELAY = 0.5  # s
LONGEST_FLOOD = 0.6  # s
BUSY = 0.1  # s
BUSY_CODES = (5, 6)


class Weather:
    """How often something happens to a request, to one that brings a new word to the first encoder, and to one whose new
    word changes something there."""

    def __init__(self, of_requests, of_words, of_changes):
        self.of_requests = of_requests
        self.of_words = of_words
        self.of_changes = of_changes


FAIR = Weather(0, 0, 0)
BEHIND = "connections closed behind a request"  # nobody sees what becomes of it


class Line(threading.Thread):
    """One connection of a client, its requests one after the other."""

    def __init__(self, relay, client):
        super().__init__(daemon=True)
        self._relay = relay
        self._client = client
        self._random = relay.random
        self._server = None
        self._held = b""
        self._before = b""  # the answer that was sent last
        self._faults = {
            "answers in pieces": self._in_pieces, "answers joined": self._joined, "answers delayed": self._delayed,
            "requests delayed": self._late_request, "answers doubled": self._doubled, "floods of an old answer": self._flood,
            "answers lost": self._pass_on, "requests lost": lambda request: None, "busy spells": self._busy,
            "connections closed before an answer": self._close, BEHIND: self._close_behind,
            "connections closed while idle": self._close_idle}

    def run(self):
        with contextlib.suppress(OSError, Closed), self._client, Wire(self._relay.ring.port) as self._server:
            while True:
                self._carry(receive(self._client))

    def _carry(self, request):
        if time.monotonic() < self._relay.busy_until:
            self._answer_busy(request)
        elif self._relay.strikes(request):
            is_worst = self._relay.changes_something(request) and self._random.random() < 0.4
            kind = BEHIND if is_worst else self._random.choice(list(self._faults))
            self._relay.note(kind, request)
            self._faults[kind](request)
        else:
            self._send(self._pass_on(request))

    def _pass_on(self, request):
        return self._relay.pass_on(self._server, request)

    def _send(self, answer):
        self._client.sendall(self._held + answer, socket.MSG_NOSIGNAL)
        self._held = b""
        self._before = answer

    def _in_pieces(self, request):
        answer = rest = self._pass_on(request)
        while rest:
            part = self._random.randint(1, len(rest))
            self._send(rest[:part])
            rest = rest[part:]
            time.sleep(self._random.uniform(0, 0.1))
        self._before = answer

    def _joined(self, request):
        self._held += self._pass_on(request)  # to be sent with the next one

    def _delayed(self, request):
        answer = self._pass_on(request)
        time.sleep(self._random.uniform(0, LONGEST_DELAY))
        self._send(answer)

    def _late_request(self, request):
        time.sleep(self._random.uniform(0, LONGEST_DELAY))
        self._send(self._pass_on(request))

    def _doubled(self, request):
        self._send(2 * self._pass_on(request))

    def _flood(self, request):
        answer, old = self._pass_on(request), self._before
        until = time.monotonic() + self._random.uniform(0.05, LONGEST_FLOOD)
        while old and time.monotonic() < until:
            self._client.sendall(old, socket.MSG_NOSIGNAL)
        self._send(answer)

    def _busy(self, request):
        self._relay.busy_until = time.monotonic() + BUSY
        self._answer_busy(request)

    def _answer_busy(self, request):
        code = self._random.choice(BUSY_CODES)
        self._send(request[:4] + struct.pack(">HBBB", 3, request[6], function(request) | 0x80, code))

    def _close(self, _):
        if self._random.random() < 0.5:  # at once, with a reset
            self._client.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
        raise Closed

    def _close_behind(self, request):
        self._pass_on(request)
        self._close(request)

    def _close_idle(self, request):
        self._send(self._pass_on(request))
        time.sleep(self._random.uniform(0, 0.03))
        self._close(request)


class Relay:
    """Listens on this computer only; the weather may be changed at any time."""

    SHOWN = 6  # of the faults that came last

    def __init__(self, ring, random):
        self.ring = ring
        self.random = random
        self.weather = FAIR
        self.busy_until = 0
        self.writes = 0  # requests that write, since the last begin()
        self.made = collections.Counter()
        self._last = collections.deque(maxlen=self.SHOWN)
        self._lines = []
        self._listener = socket.create_server(("127.0.0.1", 0))
        self.port = self._listener.getsockname()[1]
        threading.Thread(target=self._listen, daemon=True).start()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self._listener.shutdown(socket.SHUT_RDWR)
        self._listener.close()

    def _listen(self):
        with contextlib.suppress(OSError):  # it was closed
            while True:
                client, _ = self._listener.accept()
                client.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
                line = Line(self, client)
                self._lines.append(line)
                line.start()

    def begin(self, weather):
        self.weather = weather
        self.writes = 0
        self._last.clear()

    def settle(self):
        """Until everything that the last client has sent is at the server, or lost. False: somebody is still connected."""
        time.sleep(0.02)  # for one that was connected just before its end
        lines, self._lines = self._lines, []
        for line in lines:
            line.join(10)
        return not any(line.is_alive() for line in lines)

    def brings_a_word(self, request):
        return word_written(request) not in (None, self.ring.account.word)

    def changes_something(self, request):
        word = word_written(request)
        return self.brings_a_word(request) and (is_parameter(word) or word in (RUN, PRESET))

    def strikes(self, request):
        weather = self.weather
        often = (weather.of_changes if self.changes_something(request) else
                 weather.of_words if self.brings_a_word(request) else weather.of_requests)
        return self.random.random() < often

    def note(self, kind, request):
        self.made[kind] += 1
        word = word_written(request)
        self._last.append(f"{kind} (function {function(request)}" + (")" if word is None else f", {word:08X})"))

    def pass_on(self, wire, request):
        if word_written(request) is not None:
            self.writes += 1
        return self.ring.pass_on(wire, request)

    def last(self):
        return "; ".join(self._last) or "none"
