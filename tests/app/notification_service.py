#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A notification service on a D-Bus of its own, for tests of whatever shows notices on the desktop.

Written from the D-Bus specification and the Desktop Notifications Specification 1.2 alone; it shares no code
with the program, and needs no library. Prints "ready", then each call as one line of JSON. Lines on its
standard input: "click ID" (the user clicks on the notice), "quit". With --mute it never answers a call.
"""

import argparse
import json
import os
import select
import socket
import struct
import sys

NAME = "org.freedesktop.Notifications"
PATH = "/org/freedesktop/Notifications"
CALL, RETURN, ERROR, SIGNAL = 1, 2, 3, 4
FIELDS = {1: "path", 2: "interface", 3: "member", 4: "error", 5: "reply", 6: "destination", 7: "sender", 8: "signature"}


def alignment(kind):
    return {"y": 1, "g": 1, "v": 1, "n": 2, "q": 2, "b": 4, "i": 4, "u": 4, "s": 4, "o": 4, "a": 4}.get(kind, 8)


def one_type(signature):
    """The first complete type, and the rest."""
    if signature[0] == "a":
        inner, rest = one_type(signature[1:])
        return "a" + inner, rest
    if signature[0] in "({":
        depth = 0
        for i, letter in enumerate(signature):
            depth += (letter in "({") - (letter in ")}")
            if depth == 0:
                return signature[: i + 1], signature[i + 1:]
    return signature[0], signature[1:]


class Reader:
    def __init__(self, data, order):
        self.data, self.order, self.at = data, order, 0

    def align(self, size):
        self.at += -self.at % size

    def number(self, letter):
        size = struct.calcsize(letter)
        self.align(size)
        value = struct.unpack_from(self.order + letter, self.data, self.at)[0]
        self.at += size
        return value

    def text(self, length):
        value = self.data[self.at: self.at + length].decode()
        self.at += length + 1
        return value

    def value(self, kind):
        self.align(alignment(kind[0]))
        simple = {"y": "B", "n": "h", "q": "H", "i": "i", "u": "I", "x": "q", "t": "Q", "d": "d"}
        if kind in simple:
            return self.number(simple[kind])
        if kind == "b":
            return bool(self.number("I"))
        if kind in "so":
            return self.text(self.number("I"))
        if kind == "g":
            return self.text(self.number("B"))
        if kind == "v":
            return self.value(self.value("g"))
        if kind[0] == "a":
            return self.array(kind[1:])
        return self.values(kind[1:-1])

    def array(self, kind):
        length = self.number("I")
        self.align(alignment(kind[0]))
        end, items = self.at + length, []
        while self.at < end:
            items.append(self.value(kind))
        return dict(items) if kind[0] == "{" else items

    def values(self, signature):
        values = []
        while signature:
            kind, signature = one_type(signature)
            values.append(self.value(kind))
        return values


class Writer:
    def __init__(self):
        self.data = b""

    def align(self, size):
        self.data += b"\0" * (-len(self.data) % size)

    def value(self, kind, value):
        self.align(alignment(kind[0]))
        if kind in "so":
            text = value.encode()
            self.data += struct.pack("<I", len(text)) + text + b"\0"
        elif kind == "g":
            self.data += bytes([len(value)]) + value.encode() + b"\0"
        elif kind == "u":
            self.data += struct.pack("<I", value)
        elif kind == "as":
            texts = Writer()
            for text in value:
                texts.value("s", text)
            self.data += struct.pack("<I", len(texts.data)) + texts.data
        else:
            raise ValueError(kind)


class Bus:
    def __init__(self, path):
        self.socket = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
        self.socket.connect(path)
        self.socket.sendall(b"\0AUTH EXTERNAL " + str(os.getuid()).encode().hex().encode() + b"\r\n")
        assert self.socket.recv(200).startswith(b"OK")
        self.socket.sendall(b"BEGIN\r\n")
        self.serial, self.unread = 0, b""

    def send(self, kind, signature="", values=(), flags=0, **fields):
        body = Writer()
        rest = signature
        for value in values:
            one, rest = one_type(rest)
            body.value(one, value)
        self.serial += 1
        entries = Writer()
        codes = {name: code for code, name in FIELDS.items()}
        if signature:
            fields["signature"] = signature
        for name, value in fields.items():
            entries.align(8)
            form = {"path": "o", "reply": "u", "signature": "g"}.get(name, "s")
            entries.data += bytes([codes[name]])
            entries.value("g", form)
            entries.value(form, value)
        head = Writer()
        head.data = struct.pack("<BBBBIII", ord("l"), kind, flags, 1, len(body.data), self.serial, len(entries.data))
        head.data += entries.data
        head.align(8)
        self.socket.sendall(head.data + body.data)

    def messages(self):
        """Those that have arrived."""
        got = self.socket.recv(65536)
        if not got:
            sys.exit(0)
        self.unread += got
        while len(self.unread) >= 16:
            order = "<" if self.unread[:1] == b"l" else ">"
            body, serial, fields = struct.unpack_from(order + "III", self.unread, 4)
            start = 16 + fields + -fields % 8
            if len(self.unread) < start + body:
                return
            reader = Reader(self.unread[:start], order)
            reader.at = 12
            head = {FIELDS.get(code, code): value for code, value in reader.value("a(yv)")}
            head["kind"], head["serial"] = self.unread[1], serial
            head["values"] = Reader(self.unread[start: start + body], order).values(head.get("signature", ""))
            self.unread = self.unread[start + body:]
            yield head


class Service:
    def __init__(self, bus, capabilities, mute):
        self.bus, self.capabilities, self.mute, self.last = bus, capabilities, mute, 0

    def take(self, message):
        if message["kind"] != CALL:
            return
        print(json.dumps({"call": message["member"], "values": message["values"]}), flush=True)
        if self.mute:
            return
        answers = {"GetCapabilities": ("as", lambda _: [self.capabilities]), "Notify": ("u", self.show),
                   "CloseNotification": ("", self.close)}
        signature, answer = answers[message["member"]]
        values = answer(message["values"])
        self.bus.send(RETURN, signature, values, 1, reply=message["serial"], destination=message["sender"])

    def show(self, values):
        if values[1] == 0:
            self.last += 1
            return [self.last]
        return [values[1]]

    def close(self, values):
        self.signal("NotificationClosed", "uu", [values[0], 3])
        return []

    def signal(self, member, signature, values):
        self.bus.send(SIGNAL, signature, values, 1, path=PATH, interface=NAME, member=member)

    def obey(self, line):
        words = line.split()
        if words[:1] == ["click"]:
            self.signal("ActivationToken", "us", [int(words[1]), "token of the click"])
            self.signal("ActionInvoked", "us", [int(words[1]), "default"])
        else:
            sys.exit(0)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("socket", help="of the bus")
    parser.add_argument("--capabilities", default="", help="separated by commas")
    parser.add_argument("--mute", action="store_true", help="never answers")
    options = parser.parse_args()
    bus = Bus(options.socket)
    to_bus = {"path": "/org/freedesktop/DBus", "interface": "org.freedesktop.DBus", "destination": "org.freedesktop.DBus"}
    bus.send(CALL, member="Hello", **to_bus)
    bus.send(CALL, "su", [NAME, 0], member="RequestName", **to_bus)
    service = Service(bus, [name for name in options.capabilities.split(",") if name], options.mute)
    is_ready = False
    while True:
        ready, _, _ = select.select([bus.socket, sys.stdin], [], [])
        if sys.stdin in ready:
            service.obey(sys.stdin.readline())
        if bus.socket in ready:
            for message in bus.messages():
                if not is_ready and message.get("reply") == 2:
                    is_ready = True
                    print("ready", flush=True)
                service.take(message)


main()
