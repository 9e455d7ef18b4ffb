#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# findings/pty-parity.sh: a pseudo terminal can be opened with a parity once, and then with the same parity no more.
#
# Modbus RTU is 8E1 by its standard, and a simulated slave sits behind a pseudo terminal. A pty has no parity: the kernel drops PARENB
# without an error. tcsetattr() of the C library looks afterwards whether anything it was asked for has been taken, and says EINVAL if
# nothing has. So the first open succeeds, since the speed or another flag changes as well, and an open with the same settings but the
# parity fails, by whichever program. Seen with pyserial 3.5 (Debian's python3-serial 3.5-1.1), glibc 2.36, Linux 6.18:
#
#   even: opened, parity is off
#   even: (22, 'Invalid argument')
#   none: opened, parity is off
#   even: (22, 'Invalid argument')
#
# What follows for a program: on a pty it asks for no parity, which is what it gets anyway; EINVAL from there does not mean that the
# speed or the format are wrong.
#
# Installs python3-serial in a temporary folder; needs apt-get, dpkg and python3. Fails if the behaviour changes.
set -euo pipefail

version=3.5-1.1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download "python3-serial=$version" >/dev/null 2>&1
dpkg -x python3-serial_*.deb serial

cat >open.py <<'PYTHON'
import os
import pty
import termios

import serial

master, slave = pty.openpty()
for word, parity in (("even", "E"), ("even", "E"), ("none", "N"), ("even", "E")):
    try:
        port = serial.Serial(os.ttyname(slave), 19200, parity=parity)
        has_parity = termios.tcgetattr(port.fd)[2] & termios.PARENB
        print(f"{word}: opened, parity is {'on' if has_parity else 'off'}")
        port.close()
    except termios.error as error:
        print(f"{word}: {error}")
PYTHON

PYTHONPATH=serial/usr/lib/python3/dist-packages python3 open.py >seen
cat >expected <<'TEXT'
even: opened, parity is off
even: (22, 'Invalid argument')
none: opened, parity is off
even: (22, 'Invalid argument')
TEXT
echo "python3-serial $version, $(ldd --version | head -n 1), Linux $(uname -r)"
cat seen
diff expected seen
