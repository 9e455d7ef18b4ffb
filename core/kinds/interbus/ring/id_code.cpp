// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/ring/id_code.h"

#include "bus/participant.h"
#include "catalog/device_description.h"
#include "vocabulary/find_by.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace codewheel {
namespace {

constexpr unsigned outBit = 1U << 0;
constexpr unsigned inBit = 1U << 1;
constexpr unsigned directionBits = outBit | inBit;
constexpr unsigned drivePcpClass = 0xE0;
constexpr unsigned encoderPcpClass = 0xF4;
constexpr int bitsPerWord = 16;

struct IdCodeRow
{
    unsigned idCode;
    const char *name;
    bool isLocal = false;
};
constexpr std::array idCodes{
    IdCodeRow{0x01, QT_TRANSLATE_NOOP("IdCode", "digital output")},
    IdCodeRow{0x02, QT_TRANSLATE_NOOP("IdCode", "digital input")},
    IdCodeRow{0x03, QT_TRANSLATE_NOOP("IdCode", "digital input and output")},
    IdCodeRow{busTerminalIdCode, QT_TRANSLATE_NOOP("IdCode", "bus terminal")},
    IdCodeRow{0x31, QT_TRANSLATE_NOOP("IdCode", "analog output")},
    IdCodeRow{0x32, QT_TRANSLATE_NOOP("IdCode", "analog input")},
    IdCodeRow{0x33, QT_TRANSLATE_NOOP("IdCode", "analog input and output")},
    IdCodeRow{0x36, QT_TRANSLATE_NOOP("IdCode", "encoder K1 or K2")},
    IdCodeRow{0x37, QT_TRANSLATE_NOOP("IdCode", "encoder K3")},
    IdCodeRow{0xB2, QT_TRANSLATE_NOOP("IdCode", "encoder K1 or K2, Loop 2"), true},
    IdCodeRow{0xB3, QT_TRANSLATE_NOOP("IdCode", "encoder K3, Loop 2"), true},
    IdCodeRow{0xBE, QT_TRANSLATE_NOOP("IdCode", "Inline digital input"), true},
    IdCodeRow{0xE0, QT_TRANSLATE_NOOP("IdCode", "drive with PCP")},
    IdCodeRow{0xE1, QT_TRANSLATE_NOOP("IdCode", "drive with PCP")},
    IdCodeRow{0xE3, QT_TRANSLATE_NOOP("IdCode", "drive with PCP")},
    IdCodeRow{0xF7, QT_TRANSLATE_NOOP("IdCode", "encoder K4")},
};

int wordsFor(int bits)
{
    return (bits + bitsPerWord - 1) / bitsPerWord;
}

} // namespace

bool isPcp(unsigned idCode)
{
    const unsigned pcpClass = idCode & ~directionBits;
    return pcpClass == drivePcpClass || pcpClass == encoderPcpClass;
}

std::optional<int> pcpWords(unsigned idCode)
{
    if (!isPcp(idCode))
        return 0;
    switch (idCode & directionBits) {
    case 0b00:
        return 2;
    case 0b01:
        return 4;
    case 0b11:
        return 1;
    default:
        return std::nullopt;
    }
}

int lengthBits(unsigned lengthCode)
{
    constexpr std::array bitsPerUnit{16, 4, 8, 1}; // word, nibble, byte, bit
    return bitsPerUnit.at(lengthCode >> 6 & 0b11) * static_cast<int>(lengthCode & 0x3F);
}

RingDevice deviceOf(unsigned deviceCode)
{
    RingDevice device;
    device.deviceCode = deviceCode;
    if (device.idCode() == busTerminalIdCode)
        return device;
    const int words = wordsFor(lengthBits(deviceCode >> 8 & 0xFF));
    if (isPcp(device.idCode())) {
        device.inWords = device.outWords = std::max(0, words - pcpWords(device.idCode()).value_or(0));
        return device;
    }
    device.inWords = (device.idCode() & inBit) != 0 ? words : 0;
    device.outWords = (device.idCode() & outBit) != 0 ? words : 0;
    return device;
}

QString idCodeName(unsigned idCode)
{
    const IdCodeRow *kind = findBy(idCodes, idCode, &IdCodeRow::idCode);
    return kind ? QCoreApplication::translate("IdCode", kind->name) : QString();
}

QString nameOrTerminal(const RingDevice &device, const DeviceDescription *description)
{
    return !description && device.idCode() == busTerminalIdCode
               ? QCoreApplication::translate("Participant", "bus terminal")
               : participantName(description);
}

QString ringDeviceName(const RingDevice &device, const DeviceDescription *description)
{
    const QString kind = description ? description->fullName() : idCodeName(device.idCode());
    return kind.isEmpty() ? nameOrTerminal(device, description) : kind;
}

bool standsOnLocalBus(unsigned idCode)
{
    const IdCodeRow *kind = findBy(idCodes, idCode, &IdCodeRow::idCode);
    return kind && kind->isLocal;
}

} // namespace codewheel
