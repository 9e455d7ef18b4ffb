#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A ring of FRABA K3 encoders behind a Modbus gateway, made with pymodbus, for tests of its clients.

Written from the manuals alone; it shares no code with the program. It serves Modbus TCP on a port that the system
chooses, or with --rtu a pseudo terminal, and prints the port or the path as its first line. IN is in the input
registers, OUT in the holding registers. It ends when its standard input is closed; for each line "writes" it prints
how often OUT was written, and for "out" all OUT words.
"""

import argparse
import asyncio
import logging
import os
import pty
import select
import sys
import threading
import tty

from pymodbus.datastore import ModbusSequentialDataBlock, ModbusServerContext, ModbusSlaveContext
from pymodbus.server.async_io import ModbusSerialServer, ModbusTcpServer
from pymodbus.transaction import ModbusRtuFramer

RUN = 0x80000000
PRESET = 0x40000000
CONFIRMED = 0xC0000000
READ_OUT = 0x2021
ANSWER = 0xA0000000
DATA = 0x01FFFFFF
PROGRAM = 0x20800000
CAM_CONFIGURATION = 0x2040
CAM_SHIFT = 0x2010
CAM_READ_OUT = 0x2020
STEPS, REVOLUTIONS, DIRECTION, PRESET_VALUE, ZERO_OFFSET = 1, 2, 3, 4, 5


class Encoder:
    """The handshake of a FRABA K3 (manual 5.2, 5.3, cams 5.4.4), each word acting at once."""

    def __init__(self, number):
        self.values = {STEPS: 8192, REVOLUTIONS: 1, DIRECTION: 3, PRESET_VALUE: 0, ZERO_OFFSET: 0}
        self.pending = None  # in operation
        self.confirmation = 0
        self.position = 1000 * number
        self.number = number
        self.preset_flag = 0
        self.out = 0
        self.program = 0  # of cams, 0: position mode
        self.cams = {}  # of all programs, by the code that reads them
        self.parameterizes_cams = False

    def take(self, out):
        before, self.out = self.out, out
        if out == before:
            return
        if out & 0xFFFFFFF0 == PROGRAM:
            self.program = out & 0xF
            self.parameterizes_cams = False
        elif self.program:
            self.take_cam(out)
        elif out & RUN:
            if self.pending:
                self.values.update(self.pending)
            self.pending = None
        elif out == PRESET:
            if self.pending is None:
                self.position = self.values[PRESET_VALUE]
                self.preset_flag = 0
        elif out >> 29 == 0 and out >> 25:
            number, data = out >> 25, out & DATA
            self.pending = self.pending or {}
            self.pending[number] = data
            self.confirmation = CONFIRMED | out
            if number == PRESET_VALUE:
                self.preset_flag = 1

    def take_cam(self, out):
        code = {2: 0x10, 3: 0x20}.get(out >> 29)
        if out & RUN:
            self.parameterizes_cams = False
            return
        if code:
            self.cams[self.program, code + (out >> 25 & 0xF)] = out & DATA
        elif out >> 16 == CAM_CONFIGURATION:
            self.cams[self.program, 0] = out & 0xFFFF
        elif out >> 16 == CAM_SHIFT:
            self.cams[self.program, 0x40] = out & 0xFF
        else:
            return
        self.parameterizes_cams = True
        self.confirmation = CONFIRMED | out

    def read_out(self, code):
        others = {
            0: 4710 + self.number,
            6: self.preset_flag,
            7: 100,
            8: 10,
            9: 1,
            10: 0,
            12: 250,
        }
        return ANSWER | others.get(code, self.values.get(code, 0))

    def shown(self):
        if self.out >> 16 == READ_OUT:
            return self.read_out(self.out & 0xFF)
        if self.program and self.out >> 16 == CAM_READ_OUT:
            return ANSWER | self.cams.get((self.program, self.out & 0xFF), 0)
        if self.program:
            return self.confirmation if self.parameterizes_cams else self.position << 8
        return self.confirmation if self.pending is not None else self.position


class Ring:
    def __init__(self, options):
        self.options = options
        self.encoders = [Encoder(i + 1) for i in range(options.devices)]
        if options.pending:
            self.encoders[0].take(options.pending)
        for word in options.left:
            self.encoders[0].take(word)
        self.writes = 0
        self.times = 0  # that the word came behind which it vanishes
        self.words = 0  # of them, those with a word other than 0: a job is under way

    def vanish_in_time(self, before):
        if self.writes == self.options.vanish_at_write:
            os._exit(0)
        out = self.encoders[0].out
        if out == self.options.vanish_behind and out != before:
            self.times += 1
            if self.times == self.options.vanish_at:
                os._exit(0)  # without an answer

    def arranged(self, pair):
        """Of the registers of a word, high word first, or back."""
        if self.options.exchange_bytes:
            pair = [(r >> 8) | (r & 0xFF) << 8 for r in pair]
        return pair[::-1] if self.options.low_word_first else pair

    def registers_of(self, word):
        return self.arranged([word >> 16, word & 0xFFFF])

    def word_of(self, pair):
        high, low = self.arranged(pair)
        return high << 16 | low


class In(ModbusSequentialDataBlock):
    def __init__(self, ring):
        super().__init__(0, [0] * (ring.options.registers or 2 * len(ring.encoders)))
        self.ring = ring

    def getValues(self, address, count=1):
        image = []
        for encoder in self.ring.encoders:
            image += self.ring.registers_of(encoder.shown())
        return image[address : address + count]


class Out(ModbusSequentialDataBlock):
    def __init__(self, ring):
        left = ring.registers_of(ring.options.left[-1]) if ring.options.left else [0, 0]
        super().__init__(0, left + [0] * (2 * len(ring.encoders) - 2))
        self.ring = ring

    def setValues(self, address, values):
        super().setValues(address, values)
        self.ring.writes += 1
        if any(values):
            self.ring.words += 1
            if self.ring.words == self.ring.options.other_writer:
                super().setValues(2, self.ring.registers_of(RUN))  # to the second encoder
        image = super().getValues(0, 2 * len(self.ring.encoders))
        before = self.ring.encoders[0].out
        for i, encoder in enumerate(self.ring.encoders):
            encoder.take(self.ring.word_of(image[2 * i : 2 * i + 2]))
        self.ring.vanish_in_time(before)


class Hidden(Out):
    """Cannot be read back: to reads there are no such registers."""

    def validate(self, address, count=1):
        return False


def context(ring):
    out = Hidden(ring) if ring.options.no_read_back else Out(ring)
    unit = ModbusSlaveContext(ir=In(ring), hr=out, zero_mode=True)
    return ModbusServerContext(slaves={ring.options.unit: unit}, single=False)


def carry(one, other):
    ends = {one: other, other: one}
    while True:
        for end in select.select(list(ends), [], [])[0]:
            os.write(ends[end], os.read(end, 512))


def null_modem():
    """The paths of two pseudo terminals that are connected."""
    pairs = [pty.openpty() for _ in range(2)]
    for _, slave in pairs:
        tty.setraw(slave)
    threading.Thread(target=carry, args=[master for master, _ in pairs], daemon=True).start()
    return [os.ttyname(slave) for _, slave in pairs]


async def answer_questions(ring):
    loop = asyncio.get_running_loop()
    while True:
        line = await loop.run_in_executor(None, sys.stdin.readline)
        if not line:
            return
        if line.strip() == "writes":
            print(ring.writes, flush=True)
        elif line.strip() == "out":
            print(" ".join(f"{encoder.out:08X}" for encoder in ring.encoders), flush=True)


async def relay_one(reader, writer, port, delay):
    """One request and its answer; the connection is closed a moment later."""
    try:
        theirs, ours = await asyncio.open_connection("127.0.0.1", port)
        for source, sink in (reader, ours), (theirs, writer):
            header = await source.readexactly(6)
            sink.write(header + await source.readexactly(header[4] << 8 | header[5]))
            await sink.drain()
        ours.close()
        await asyncio.sleep(delay)
    except (asyncio.IncompleteReadError, ConnectionError):
        pass  # the client has gone
    writer.close()


async def serve(ring):
    if ring.options.rtu:
        ours, theirs = null_modem()
        server = ModbusSerialServer(context(ring), framer=ModbusRtuFramer, port=ours, baudrate=19200, timeout=1)
        await server.start()
        print(theirs, flush=True)
        await answer_questions(ring)
        await server.shutdown()
        return
    server = ModbusTcpServer(context(ring), address=("127.0.0.1", 0))
    serving = asyncio.ensure_future(server.serve_forever())
    await server.serving
    port = server.server.sockets[0].getsockname()[1]
    if ring.options.closes is not None:
        delay = ring.options.closes / 1000
        behind = port
        relay = await asyncio.start_server(lambda r, w: relay_one(r, w, behind, delay), "127.0.0.1", 0)
        port = relay.sockets[0].getsockname()[1]
    print(port, flush=True)
    await answer_questions(ring)
    serving.cancel()


logging.disable()  # of clients that go, and of exceptions
parser = argparse.ArgumentParser(description=__doc__)
parser.add_argument("--rtu", action="store_true")
parser.add_argument("--devices", type=int, default=3)
parser.add_argument("--unit", type=int, default=1)
parser.add_argument("--registers", type=int, default=0, help="of IN that exist; 0: all that are needed")
parser.add_argument("--low-word-first", action="store_true")
parser.add_argument("--exchange-bytes", action="store_true")
parser.add_argument("--no-read-back", action="store_true")
parser.add_argument("--other-writer", type=int, default=0, help="writes to the second encoder after so many writes of a job")
parser.add_argument("--pending", type=lambda word: int(word, 16), help="the first encoder was left in parameterization")
parser.add_argument("--left", type=lambda word: int(word, 16), nargs="+", default=[], help="the first encoder was sent these words, the last of which is still in OUT")
parser.add_argument("--vanish-behind", type=lambda word: int(word, 16), help="ends once the first encoder has this word")
parser.add_argument("--vanish-at-write", type=int, help="ends with so many writes")
parser.add_argument("--closes", type=int, help="closes each connection so many ms behind its answer")
parser.add_argument("--vanish-at", type=int, default=1, help="once it has it for this time")
asyncio.run(serve(Ring(parser.parse_args())))
