// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/explain_word.h"

#include <QCoreApplication>

// FRABA manual 5.2 and 10; Baumer manual 2.2 and 2.3.
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
    static QString outText(k3::Dialect dialect, int bit);
    static QString inText(k3::Dialect dialect, int bit);
};

QString BitText::outText(k3::Dialect dialect, int bit)
{
    const bool fraba = dialect == k3::Dialect::fraba;
    if (bit == startBit)
        return tr("D31: start (run), when it changes from 0 to 1");
    if (bit == presetBit)
        return fraba ? tr("D30: initialise the preset; in cam mode: start or stop of a cam")
                     : tr("D30: initialise the preset");
    if (bit == manufacturerBit)
        return fraba                            ? tr("D29: FRABA command")
               : dialect == k3::Dialect::baumer ? tr("D29: ignored by this encoder")
                                                : tr("D29: manufacturer specific");
    if (bit >= lowestNumberBit)
        return fraba ? tr("D28..D25: parameter number; in cam mode: number of the cam")
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

} // namespace

QString bitText(const DeviceDescription &device, WordDirection direction, int bit)
{
    if (bit < 0 || bit > startBit)
        return {};
    return direction == WordDirection::out ? BitText::outText(device.dialect, bit)
                                           : BitText::inText(device.dialect, bit);
}

} // namespace codewheel
