# SPDX-License-Identifier: GPL-3.0-or-later
# A client of the served ring that shares no code with it: python3-pymodbus. Arguments: tcp HOST PORT, or
# rtu PORT; then the unit. Ends with 0 if every answer is as docs/manual/serving.md says.
import sys

from pymodbus.client import ModbusSerialClient, ModbusTcpClient
from pymodbus.mei_message import ReadDeviceInformationRequest
from pymodbus.register_read_message import ReadWriteMultipleRegistersRequest
from pymodbus.register_write_message import MaskWriteRegisterRequest


def expect(what, got, wanted):
    if got != wanted:
        sys.exit(f"{what}: {got} instead of {wanted}")


def exception_of(answer):
    return answer.exception_code if answer.isError() else None


def main():
    if sys.argv[1] == "tcp":
        client = ModbusTcpClient(sys.argv[2], port=int(sys.argv[3]), timeout=20)
    else:
        client = ModbusSerialClient(sys.argv[2], timeout=20)  # a pseudo terminal has no parity
    unit = int(sys.argv[-1])
    if not client.connect():
        sys.exit("no connection")
    expect("write 16", client.write_registers(0, [0x1234, 0x5678], slave=unit).isError(), False)
    expect("read 3", client.read_holding_registers(0, 2, slave=unit).registers, [0x1234, 0x5678])
    expect("write 6", client.write_register(1, 0x0001, slave=unit).isError(), False)
    expect("half a word", client.read_holding_registers(0, 2, slave=unit).registers, [0x1234, 0x0001])
    masked = client.execute(to(unit, MaskWriteRegisterRequest(1, 0xFFF0, 0x0002)))
    expect("write 22", masked.isError(), False)
    expect("masked", client.read_holding_registers(1, 1, slave=unit).registers, [0x0002])
    both = client.execute(to(unit, ReadWriteMultipleRegistersRequest(
        read_address=4096, read_count=2, write_address=2, write_registers=[0, 0])))
    expect("function 23", len(both.registers), 2)
    expect("read 4", client.read_input_registers(0, 2, slave=unit).isError(), False)
    expect("status", client.read_input_registers(8192, 2, slave=unit).registers, [0x00E0, 0])
    expect("coils", exception_of(client.read_coils(0, 1, slave=unit)), 1)
    expect("identification", exception_of(client.execute(to(unit, ReadDeviceInformationRequest(0x01, 0x00)))), 1)
    expect("outside", exception_of(client.read_holding_registers(4000, 1, slave=unit)), 2)
    expect("write IN", exception_of(client.write_register(4096, 1, slave=unit)), 2)
    expect("after all", client.read_holding_registers(0, 2, slave=unit).registers, [0x1234, 0x0002])
    client.close()


# The client's own functions forget the unit of some requests.
def to(unit, request):
    request.unit_id = unit
    return request


main()
