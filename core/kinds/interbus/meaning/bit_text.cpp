// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/meaning/meaning_parts.h"
#include "kinds/interbus/meaning/position_format.h"
#include "kinds/interbus/words/k3_explain.h"
#include "kinds/interbus/words/k3_word.h"
#include "kinds/interbus/words/la66_word.h"

#include <QCoreApplication>

// FRABA manual 5.2 and 10; Baumer manual 2.2 and 2.3; LA-66 manual 2.
namespace codewheel {
namespace {

constexpr int startBit = 31;
constexpr int presetBit = 30;
constexpr int manufacturerBit = 29;
constexpr int lowestNumberBit = 25;
constexpr int readOutRequestBit = 16;

class BitText
{
    Q_DECLARE_TR_FUNCTIONS(BitText)

public:
    static QString outText(const DeviceDescription &device, int bit);
    static QString inText(k3::Dialect dialect, int bit);
    static QString rodText(WordDirection direction, int bit);
    static QString positionText(const PositionWord &format, WordDirection direction, int bit);
};

QString BitText::outText(const DeviceDescription &device, int bit)
{
    const bool fraba = device.dialect == k3::Dialect::fraba;
    if (bit == startBit)
        return tr("D31: start (run), when it changes from 0 to 1");
    if (bit == presetBit)
        return device.mayHaveModes() ? tr("D30: initialise the preset; in cam mode: start or stop of a cam")
                                     : tr("D30: initialise the preset");
    if (bit == manufacturerBit)
        return fraba                                   ? tr("D29: FRABA command")
               : device.dialect == k3::Dialect::baumer ? tr("D29: ignored by this encoder")
                                                       : tr("D29: manufacturer specific");
    if (bit >= lowestNumberBit)
        return device.mayHaveModes() ? tr("D28..D25: parameter number; in cam mode: number of the cam")
                                     : tr("D28..D25: parameter number");
    if (fraba && bit == readOutRequestBit)
        return tr("D24..D0: parameter data; D16 with D29 and D21: read out as long as it is 1");
    return tr("D24..D0: parameter data");
}

QString BitText::inText(k3::Dialect dialect, int bit)
{
    const bool fraba = dialect == k3::Dialect::fraba;
    if (bit == startBit)
        return tr("D31: position not valid");
    if (bit == presetBit)
        return tr("D30: parameterization");
    if (bit == manufacturerBit)
        return fraba                            ? tr("D29: with D31: read-out value or self test")
               : dialect == k3::Dialect::baumer ? tr("D29: means nothing at this encoder")
                                                : tr("D29: manufacturer specific");
    if (bit >= lowestNumberBit)
        return tr("D28..D25: parameter number, or error number");
    return fraba ? tr("D24..D0: position, confirmed data or read-out value")
                 : tr("D24..D0: position or confirmed data");
}

// LA-66 manual 2.2 and 2.3.
QString BitText::rodText(WordDirection direction, int bit)
{
    constexpr int writeBit = 30;
    constexpr int errorBit = 29;
    constexpr int reservedBit = 28;
    const bool out = direction == WordDirection::out;
    if (bit == startBit)
        return out ? tr("D31: service bit, asks when it changes from 0 to 1")
                   : tr("D31: service bit, acknowledges");
    if (bit == writeBit)
        return tr("D30: 0 read, 1 write");
    if (bit == errorBit)
        return out ? tr("D29: always 0") : tr("D29: error");
    if (bit == reservedBit)
        return tr("D28: always 0");
    if (bit >= la66::dataBits)
        return tr("D27..D24: service number");
    return out ? tr("D23..D0: data to write") : tr("D23..D0: position; in service mode data written or read");
}

// FRABA manual 2.1; TWK, table VI.
QString BitText::positionText(const PositionWord &format, WordDirection direction, int bit)
{
    if (direction == WordDirection::out)
        return format.hasOut ? tr("D31..D0: no source describes them")
                             : tr("D%1: this encoder has no OUT word").arg(bit);
    if (bit >= format.positionBits)
        return tr("D%1: not used, always 0").arg(bit);
    if (format.hasStatusBits)
        return tr("D31..D0: position; no source says which four bits are status bits");
    return tr("D%1..D0: position").arg(format.positionBits - 1);
}

} // namespace

QString k3BitText(const DeviceDescription &device, WordDirection direction, int bit)
{
    return direction == WordDirection::out ? BitText::outText(device, bit)
                                           : BitText::inText(device.dialect.as<k3::Dialect>(), bit);
}

QString la66BitText(WordDirection direction, int bit)
{
    return BitText::rodText(direction, bit);
}

QString positionBitText(const DeviceDescription &device, WordDirection direction, int bit)
{
    return BitText::positionText(positionFormat(device), direction, bit);
}

} // namespace codewheel
