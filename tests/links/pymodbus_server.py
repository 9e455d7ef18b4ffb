#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A Modbus server of pymodbus, for tests of clients.

With a path it serves Modbus RTU there, otherwise Modbus TCP on a port that the system chooses. It prints the path
or the port as its first line, then serves unit 5 until its standard input is closed: input register n has the value
n + 1000, and holding register n the value n. There are 400 of each.
"""

import asyncio
import sys

from pymodbus.datastore import ModbusSequentialDataBlock, ModbusServerContext, ModbusSlaveContext
from pymodbus.server.async_io import ModbusSerialServer, ModbusTcpServer
from pymodbus.transaction import ModbusRtuFramer

REGISTERS = 400


def registers():
    unit = ModbusSlaveContext(
        ir=ModbusSequentialDataBlock(0, [n + 1000 for n in range(REGISTERS)]),
        hr=ModbusSequentialDataBlock(0, list(range(REGISTERS))),
        zero_mode=True,
    )
    return ModbusServerContext(slaves={5: unit}, single=False)


async def until_input_ends():
    await asyncio.get_running_loop().run_in_executor(None, sys.stdin.read)


async def serve_tcp():
    server = ModbusTcpServer(registers(), address=("127.0.0.1", 0))
    serving = asyncio.ensure_future(server.serve_forever())
    await server.serving
    print(server.server.sockets[0].getsockname()[1], flush=True)
    await until_input_ends()
    serving.cancel()


async def serve_line(path):
    server = ModbusSerialServer(registers(), framer=ModbusRtuFramer, port=path, baudrate=19200, timeout=1)
    await server.start()
    print(path, flush=True)
    await until_input_ends()
    await server.shutdown()


asyncio.run(serve_line(sys.argv[1]) if len(sys.argv) > 1 else serve_tcp())
