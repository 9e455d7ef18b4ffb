// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/protocol/canopen_explain.h"
#include "kinds/canopen/protocol/cob_id.h"
#include "vocabulary/hex.h"
#include "vocabulary/sentence.h"

#include <QCoreApplication>

#include <array>

namespace codewheel::canopen {
namespace {

class LssTexts
{
    Q_DECLARE_TR_FUNCTIONS(CanopenLss)

public:
    static QString switched(const LssFrame &lss);
    static QString rate(const LssFrame &lss);
    static QString fastScan(const LssFrame &lss);
    static QString request(const LssFrame &lss);
    static QString outcome(const LssFrame &lss);
    static QString answer(const LssFrame &lss);
    static QString node(const LssFrame &lss);
    static QString unknown(const LssFrame &lss);
    static QString identity(int word, std::uint32_t number);
};

constexpr std::uint8_t unconfigured = 0xFF;

QString LssTexts::identity(int word, std::uint32_t number)
{
    const std::array patterns{tr("vendor %1"), tr("product %1"), tr("revision %1"), tr("serial number %1")};
    return sentence(patterns[static_cast<std::size_t>(word)], {hexNumber(number)});
}

QString LssTexts::unknown(const LssFrame &lss)
{
    return sentence(tr("unknown command %1"), {hexNumber(static_cast<std::uint8_t>(lss.command), 2)});
}

QString LssTexts::switched(const LssFrame &lss)
{
    switch (lss.first()) {
    case 0:
        return tr("all devices back to operation");
    case 1:
        return tr("all devices to configuration");
    default:
        return sentence(tr("all devices to unknown mode %1"), {QString::number(lss.first())});
    }
}

// Only table 0 is that of CiA 301.
QString LssTexts::rate(const LssFrame &lss)
{
    constexpr std::array kiloBits{1000, 800, 500, 250, 125, 0, 50, 20, 10};
    const std::size_t place = lss.second();
    if (lss.first() == 0 && place < kiloBits.size() && kiloBits[place] != 0)
        return sentence(tr("rate %1 kBit/s"), {QString::number(kiloBits[place])});
    return sentence(tr("rate %1 of table %2"), {QString::number(place), QString::number(lss.first())});
}

QString LssTexts::fastScan(const LssFrame &lss)
{
    constexpr std::uint8_t whoIsThere = 0x80;
    if (lss.bit == whoIsThere)
        return tr("fast scan: who has no node number?");
    if (lss.word > 3)
        return tr("fast scan");
    return sentence(tr("fast scan: %1, from bit %2 on?"),
                    {identity(lss.word, lss.number), QString::number(lss.bit)});
}

QString LssTexts::node(const LssFrame &lss)
{
    const int number = lss.first();
    if (number == unconfigured)
        return tr("no node number");
    const bool isOne = number >= 1 && number <= lastNode;
    return sentence(isOne ? tr("node number %1") : tr("node number %1, which no node has"),
                    {QString::number(number)});
}

QString LssTexts::request(const LssFrame &lss)
{
    switch (lss.command) {
    case LssCommand::switchAll:
        return switched(lss);
    case LssCommand::configureNode:
        return node(lss);
    case LssCommand::configureRate:
        return rate(lss);
    case LssCommand::activateRate:
        return sentence(tr("change to the new rate, waiting %1 ms before and after"),
                        {numberText(lss.number & 0xFFFF)});
    case LssCommand::store:
        return tr("store");
    case LssCommand::selectVendor:
    case LssCommand::selectProduct:
    case LssCommand::selectRevision:
    case LssCommand::selectSerial:
        return sentence(tr("select: %1"), {identity(static_cast<int>(lss.command) & 3, lss.number)});
    case LssCommand::identifyUnconfigured:
        return tr("who has no node number?");
    case LssCommand::fastScan:
        return fastScan(lss);
    case LssCommand::inquireVendor:
        return tr("which vendor?");
    case LssCommand::inquireProduct:
        return tr("which product?");
    case LssCommand::inquireRevision:
        return tr("which revision?");
    case LssCommand::inquireSerial:
        return tr("which serial number?");
    case LssCommand::inquireNode:
        return tr("which node number?");
    default:
        return lss.command >= LssCommand::identifyVendor && lss.command <= LssCommand::identifySerialHigh
                   ? tr("who is it? By vendor, product, and ranges of revision and serial number")
                   : unknown(lss);
    }
}

// 0: taken; 255: see the second number, which is the maker's.
QString LssTexts::outcome(const LssFrame &lss)
{
    const std::uint8_t error = lss.first();
    if (lss.command == LssCommand::configureNode)
        return error == 0   ? tr("node number taken")
               : error == 1 ? tr("node number refused: out of range")
                            : sentence(tr("node number refused: error %1"), {QString::number(error)});
    if (lss.command == LssCommand::configureRate)
        return error == 0   ? tr("rate taken")
               : error == 1 ? tr("rate refused: not supported")
                            : sentence(tr("rate refused: error %1"), {QString::number(error)});
    return error == 0   ? tr("stored")
           : error == 1 ? tr("not stored: not supported")
           : error == 2 ? tr("not stored: the memory failed")
                        : sentence(tr("not stored: error %1"), {QString::number(error)});
}

QString LssTexts::answer(const LssFrame &lss)
{
    switch (lss.command) {
    case LssCommand::configureNode:
    case LssCommand::configureRate:
    case LssCommand::store:
        return outcome(lss);
    case LssCommand::selected:
        return tr("selected");
    case LssCommand::identified:
        return tr("a device is meant");
    case LssCommand::identifiedUnconfigured:
        return tr("a device has no node number");
    case LssCommand::inquireVendor:
    case LssCommand::inquireProduct:
    case LssCommand::inquireRevision:
    case LssCommand::inquireSerial:
        return identity(static_cast<int>(lss.command) - static_cast<int>(LssCommand::inquireVendor),
                        lss.number);
    case LssCommand::inquireNode:
        return node(lss);
    default:
        return unknown(lss);
    }
}

} // namespace

QString lssRequestText(const LssFrame &lss)
{
    return LssTexts::request(lss);
}

QString lssAnswerText(const LssFrame &lss)
{
    return LssTexts::answer(lss);
}

} // namespace codewheel::canopen
