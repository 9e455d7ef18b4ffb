#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# findings/python-can-logs.sh: what two frames lose on their way through the log files of python-can 4.1.0.
#
# A remote frame of one byte that was received (the guarding of node 5), and a PDO that was sent 467.5 ms later, are written by each of the
# library's writers and read again by its readers. Seen with Debian's python3-can 4.1.0-1, Python 3.11:
#
#   log  705 remote, 0 bytes, 1544106679.432500, received | 185 data, 4 bytes, 1544106679.900000, sent
#   asc  705 remote, 1 bytes, 0.000000, received | 185 data, 4 bytes, 0.467500, sent
#   csv  705 remote, 1 bytes, 1544106679.432500, received | 185 data, 4 bytes, 1544106679.900000, received
#   trc  185 data, 4 bytes, 0.467500, sent
#   blf  705 remote, 1 bytes, 1544106679.432000, received | 185 data, 4 bytes, 1544106679.899500, sent
#   asc says: timestamps absolute
#
# So a log in candump's form loses the length of a remote frame, one in Vector's asc form calls its times absolute and counts them from the
# first frame, csv loses who sent a frame, trc the remote frames, and blf, which keeps its start to the millisecond, shifts all times by the rest.
# And an error frame of candump's form (20000080h, "bus error") is read as identifier 0, without its bytes:
#
#   error frame: id 0h, 0 bytes
#
# What follows for a program that reads logs: the times of an asc file are told by themselves whether they are dates, not by its header; and
# a reader that is checked against this library is not wrong where it keeps more.
#
# Installs python3-can in a temporary folder; needs apt-get, dpkg and Python 3.11. Fails if the behaviour changes.
set -euo pipefail

version=4.1.0-1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download "python3-can=$version" python3-wrapt python3-msgpack >/dev/null 2>&1
for package in *.deb; do
    dpkg -x "$package" can
done

cat >logs.py <<'PYTHON'
import can

FRAMES = [
    can.Message(arbitration_id=0x705, is_extended_id=False, is_remote_frame=True, dlc=1, timestamp=1544106679.4325),
    can.Message(arbitration_id=0x185, is_extended_id=False, data=[1, 2, 3, 4], timestamp=1544106679.9, is_rx=False),
]


def told(frame):
    kind = "remote" if frame.is_remote_frame else "data"
    way = "received" if frame.is_rx else "sent"
    return f"{frame.arbitration_id:x} {kind}, {frame.dlc} bytes, {frame.timestamp:.6f}, {way}"


for form in ("log", "asc", "csv", "trc", "blf"):
    writer = can.Logger("frames." + form)
    for frame in FRAMES:
        writer(frame)
    writer.stop()
    print(f"{form}  " + " | ".join(told(frame) for frame in can.LogReader("frames." + form)))
with open("frames.asc") as file:
    print("asc says: " + next(line for line in file if "timestamps" in line).strip().split("  ")[1])
with open("error.log", "w") as file:
    file.write("(1544106679.432583) can0 20000080#0000000000000000\n")
for frame in can.LogReader("error.log"):
    print(f"error frame: id {frame.arbitration_id:x}h, {frame.dlc} bytes")
PYTHON

PYTHONPATH=can/usr/lib/python3/dist-packages /usr/bin/python3 logs.py >seen 2>/dev/null
cat >expected <<'TEXT'
log  705 remote, 0 bytes, 1544106679.432500, received | 185 data, 4 bytes, 1544106679.900000, sent
asc  705 remote, 1 bytes, 0.000000, received | 185 data, 4 bytes, 0.467500, sent
csv  705 remote, 1 bytes, 1544106679.432500, received | 185 data, 4 bytes, 1544106679.900000, received
trc  185 data, 4 bytes, 0.467500, sent
blf  705 remote, 1 bytes, 1544106679.432000, received | 185 data, 4 bytes, 1544106679.899500, sent
asc says: timestamps absolute
error frame: id 0h, 0 bytes
TEXT
echo "python3-can $version, $(/usr/bin/python3 --version)"
cat seen
diff expected seen
