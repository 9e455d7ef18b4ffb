# SPDX-License-Identifier: GPL-3.0-or-later
"""The simulated CAN bus as `codewheel-cli serve canopen` offers it, and what can be told of its nodes from outside."""

import os
import select
import signal
import subprocess
import time
import tty

from program import PATIENCE

OPEN = b"C\rS4\rO\r"  # 125 kBd
OPERATIONAL, STOPPED, PRE_OPERATIONAL = 1, 2, 128
NMT_STATES = {1: OPERATIONAL, 2: STOPPED, 128: PRE_OPERATIONAL, 129: PRE_OPERATIONAL, 130: PRE_OPERATIONAL}
NODES = (5, 6, 7)
DOWNLOAD, DOWNLOADED, UPLOAD, ABORTED = 1, 3, 2, 4  # command specifiers, the upper three bits
STORE, RESTORE = 0x1010, 0x1011


class Frame:
    """A data frame with a short identifier, from its line; None of any other line."""

    def __init__(self, identifier, data):
        self.identifier = identifier
        self.data = data

    @staticmethod
    def of(line):
        try:
            if line[:1] == b"t":
                return Frame(int(line[1:4], 16), bytes.fromhex(line[5:5 + 2 * int(line[4:5])].decode()))
        except ValueError:
            pass
        return None

    def line(self):
        return b"t%03X%d%s\r" % (self.identifier, len(self.data), self.data.hex().upper().encode())

    def node(self):
        return self.identifier & 0x7F

    def is_request(self):
        return self.identifier & ~0x7F == 0x600 and len(self.data) == 8

    def is_answer(self):
        return self.identifier & ~0x7F == 0x580 and len(self.data) == 8

    def is_boot_up(self):
        return self.identifier & ~0x7F == 0x700 and self.data == b"\0"

    def specifier(self):
        return self.data[0] >> 5

    def begins_write(self):
        return self.is_request() and self.specifier() == DOWNLOAD

    def object(self):
        return (self.data[1] | self.data[2] << 8, self.data[3])


class Account:
    """What the nodes did with the frames that reached them."""

    def __init__(self):
        self.states = {}  # by node
        self.sent = []  # writes that began: node and object
        self.stores = 0  # that a node has confirmed
        self._asked = {}  # by node: the frame that has no answer yet

    def sees_request(self, frame):
        if frame.identifier == 0 and len(frame.data) == 2:
            nodes = [frame.data[1]] if frame.data[1] else list(self.states)
            for node in nodes:
                self.states[node] = NMT_STATES.get(frame.data[0], self.states.get(node))
        if frame.is_request():
            self._asked[frame.node()] = frame
            if frame.begins_write():
                self.sent.append((frame.node(), frame.object()))

    def sees_answer(self, frame):
        asked = self._asked.pop(frame.node(), None) if frame.is_answer() else None
        if asked and asked.begins_write() and frame.specifier() == DOWNLOADED and asked.object()[0] in (STORE, RESTORE):
            self.stores += 1

    def is_waiting(self):
        return bool(self._asked)


class Bus:
    """Its adapter stays open from here: what a client sends is passed on by the relay of can_relay.py."""

    def __init__(self, bench, *options):
        self._process = subprocess.Popen([str(bench.cli), "serve", "canopen", "--slcan", *options], stdin=subprocess.DEVNULL,
                                         stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, env=bench.environment,
                                         cwd=bench.folder)
        path = self._process.stdout.readline().decode().strip()
        self.port = os.open(path, os.O_RDWR | os.O_NOCTTY | os.O_NONBLOCK)
        tty.setraw(self.port)
        self.account = Account()
        self._left = b""
        self.send(OPEN)
        self._await_boot()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        os.close(self.port)
        self._process.send_signal(signal.SIGTERM)
        self._process.wait(PATIENCE)
        self._process.stdout.close()

    def _await_boot(self):
        until = time.monotonic() + 5
        waited_for = set(NODES)
        while waited_for and time.monotonic() < until:
            waited_for -= {frame.node() for frame in map(Frame.of, self.receive(0.1)) if frame and frame.is_boot_up()}
        self.account.states = dict.fromkeys(NODES, PRE_OPERATIONAL)

    def send(self, line):
        frame = Frame.of(line)
        if frame:
            self.account.sees_request(frame)
        os.write(self.port, line)

    def receive(self, seconds):
        """Whole lines that have come, a BELL counts as one; waits for the first so long."""
        if select.select([self.port], [], [], seconds)[0]:
            self._left += os.read(self.port, 65536)
        lines = []
        while self._left:
            ends = [end for end in (self._left.find(b"\r"), self._left.find(b"\a")) if end >= 0]
            if not ends:
                break
            line, self._left = self._left[:min(ends) + 1], self._left[min(ends) + 1:]
            lines.append(line)
            frame = Frame.of(line)
            if frame:
                self.account.sees_answer(frame)
        return lines

    def pass_over(self, seconds):
        """What comes in so long is of no interest."""
        until = time.monotonic() + seconds
        while time.monotonic() < until:
            self.receive(0.02)

    def command(self, command, node):
        """An NMT command, without anybody in between."""
        self.send(Frame(0, bytes([command, node])).line())
        time.sleep(0.02)

    def value(self, node, index, sub=0):
        """Of an object of four octets or fewer, without anybody in between; None: the node does not have it."""
        request = Frame(0x600 + node, bytes([0x40, index & 0xFF, index >> 8, sub, 0, 0, 0, 0]))
        self.send(request.line())
        until = time.monotonic() + 2
        while time.monotonic() < until:
            for frame in map(Frame.of, self.receive(0.1)):
                if frame and frame.is_answer() and frame.node() == node and frame.object() == (index, sub):
                    return self._in(frame)
        raise RuntimeError(f"node {node} does not answer")

    @staticmethod
    def _in(frame):
        if frame.specifier() != UPLOAD:
            return None
        unused = frame.data[0] >> 2 & 3
        return int.from_bytes(frame.data[4:8 - unused], "little")
