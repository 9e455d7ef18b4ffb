#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# findings/npm-canopen-eds.sh: what the npm package "canopen" makes of an electronic data sheet (EDS, CiA 306).
#
# Four objects of an encoder, each in a form that CiA 306 allows and makers use: an identifier that depends on the node number, a lower limit
# of 0, a signed default, an array whose entries are described by CompactSubObj. Seen with canopen 6.2.1, Node 20:
#
#   1800h:1  default "$NODEID+0x180", value 0
#   6004h    from none to 4294967295
#   6030h:1  there is no such entry (CompactSubObj=2)
#   6509h    default "-5", value -5
#
# So the identifier of a PDO is 0, which is that of NMT; a limit of 0 is not told from none; and entries of a compact array are not there.
# What follows for a program that is checked against it: its values are no oracle for these three, and a device made of such a file does not
# answer to reads of 6030h:1.
#
# Installs the package in a temporary folder; needs node and npm. Fails if the behaviour changes.
set -euo pipefail

version=6.2.1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund "canopen@$version" >/dev/null 2>&1

cat >rotor.eds <<'EDS'
[FileInfo]
FileName=rotor.eds
FileVersion=1
FileRevision=1
EDSVersion=4.0
[DeviceInfo]
VendorName=Example
VendorNumber=0x1
ProductName=Rotor
ProductNumber=0x2
BaudRate_250=1
Granularity=8
NrOfTXPDO=1
[MandatoryObjects]
SupportedObjects=0
[OptionalObjects]
SupportedObjects=4
1=0x1800
2=0x6004
3=0x6030
4=0x6509
[1800]
ParameterName=TPDO1
ObjectType=0x9
SubNumber=2
[1800sub0]
ParameterName=Highest sub-index
DataType=0x5
AccessType=ro
DefaultValue=1
[1800sub1]
ParameterName=COB-ID
DataType=0x7
AccessType=rw
DefaultValue=$NODEID+0x180
[6004]
ParameterName=Position value
ObjectType=0x7
DataType=0x7
AccessType=ro
LowLimit=0
HighLimit=0xFFFFFFFF
[6030]
ParameterName=Speed value
ObjectType=0x8
DataType=0x3
AccessType=ro
CompactSubObj=2
[6509]
ParameterName=Offset value
ObjectType=0x7
DataType=0x4
AccessType=ro
DefaultValue=-5
[ManufacturerObjects]
SupportedObjects=0
EDS

cat >read.js <<'JS'
const { Eds } = require('canopen');
const eds = Eds.fromFile('rotor.eds');
const told = (entry) => `default "${entry.defaultValue}", value ${entry.value}`;
const position = eds.getEntry(0x6004);
console.log(`1800h:1  ${told(eds.getSubEntry(0x1800, 1))}`);
console.log(`6004h    from ${position.lowLimit ?? 'none'} to ${position.highLimit}`);
console.log(`6030h:1  ${eds.getSubEntry(0x6030, 1) ? 'there' : 'there is no such entry (CompactSubObj=2)'}`);
console.log(`6509h    ${told(eds.getEntry(0x6509))}`);
JS
node read.js >seen
cat >expected <<'TEXT'
1800h:1  default "$NODEID+0x180", value 0
6004h    from none to 4294967295
6030h:1  there is no such entry (CompactSubObj=2)
6509h    default "-5", value -5
TEXT
echo "canopen $version, node $(node --version)"
cat seen
diff expected seen
