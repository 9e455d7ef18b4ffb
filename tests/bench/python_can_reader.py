#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads COUNT frames from the SLCAN adapter at PORT with python-can; prints how many came, and the processor time of a
frame in us."""

import sys
import time

import can


def main():
    port, count = sys.argv[1], int(sys.argv[2])
    with can.interface.Bus(interface="slcan", channel=port, bitrate=1000000, sleep_after_open=0) as bus:
        bus.recv(5)
        begin = time.process_time()
        got = 0
        while got < count and bus.recv(5) is not None:
            got += 1
        print(got, 1e6 * (time.process_time() - begin) / max(got, 1))


main()
