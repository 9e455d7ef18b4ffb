// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/kinds/interbus/ring/written_ring.h"

#include "kinds/interbus/ring/numbering.h"
#include "kinds/interbus/words/device_number.h"

#include <QStringList>

#include <map>

namespace codewheel {
namespace {

const std::map<QString, RingDevice> kinds{
    {QStringLiteral("K1"), {{}, 0x0136, 1, 0, {}}}, {QStringLiteral("K2"), {{}, 0x0236, 2, 0, {}}},
    {QStringLiteral("K3"), {{}, 0x0237, 2, 2, {}}}, {QStringLiteral("K3L"), {{}, 0x02B3, 2, 2, {}}},
    {QStringLiteral("LA"), {{}, 0x0233, 2, 2, {}}}, {QStringLiteral("BT"), {{}, 0x000C, 0, 0, {}}},
    {QStringLiteral("DI"), {{}, 0x81BE, 1, 0, {}}}, {QStringLiteral("DI2"), {{}, 0x02BE, 2, 0, {}}},
};

} // namespace

RingStructure writtenRing(const char *text)
{
    RingStructure ring;
    for (QString word : QString::fromLatin1(text).split(u' ', Qt::SkipEmptyParts)) {
        const bool onLocalBus = word.startsWith(u'.');
        const auto level = static_cast<int>(word.count(u'/'));
        word.remove(u'.').remove(u'/');
        RingDevice participant = kinds.at(word);
        participant.number = DeviceNumber{1, onLocalBus ? 1 : 0}.node();
        participant.level = level;
        ring.push_back(participant);
    }
    numberDevices(ring);
    return ring;
}

} // namespace codewheel
