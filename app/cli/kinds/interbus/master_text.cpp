// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/kinds/interbus/master_text.h"

#include "catalog/hex_code.h"
#include "cli/call/keys.h"
#include "cli/call/text_table.h"
#include "cli/call/texts.h"
#include "kinds/interbus/ring/master_text.h"
#include "kinds/interbus/ring/ring_session.h"

#include <QJsonArray>
#include <QJsonObject>

namespace codewheel {
namespace {

QString bitNames(std::uint16_t bits)
{
    QStringList names;
    for (int bit = diagnosticBits - 1; bit >= 0; --bit)
        if ((bits >> bit & 1) != 0)
            names << diagnosticBitName(bit);
    return names.join(QStringLiteral(", "));
}

constexpr NamedValue<MasterState> masterStateKeys[] = {
    {"ready", MasterState::ready},
    {"active", MasterState::active},
    {"run", MasterState::run},
    {"busFail", MasterState::busFail},
};
constexpr NamedValue<FaultSpot> spotKeys[] = {
    {"device", FaultSpot::device},
    {"outgoingRemoteBus", FaultSpot::outgoingRemoteBus},
    {"outgoingLocalBus", FaultSpot::outgoingLocalBus},
};

QJsonValue placeJson(const std::optional<FaultPlace> &place)
{
    if (!place)
        return {};
    return QJsonObject{{QStringLiteral("place"), place->number.toString()},
                       {QStringLiteral("spot"), keyOf(spotKeys, place->spot)}};
}

QString hex(std::uint16_t word)
{
    return QStringLiteral("%1").arg(word, 4, 16, QLatin1Char('0')).toUpper();
}

QJsonArray devicesJson(const RingSession &bus, const MasterStatus &master)
{
    QJsonArray devices;
    for (std::size_t i = 0; i < std::min(bus.structure().size(), master.devices.size()); ++i)
        devices.append(QJsonObject{{QStringLiteral("place"), bus.structure()[i].number.toString()},
                                   {QStringLiteral("inRing"), master.devices[i].inRing},
                                   {QStringLiteral("peripheralFault"), master.devices[i].peripheralFault}});
    return devices;
}

// Of segments that are off or faulty.
QString segmentLines(const MasterStatus &master)
{
    QString text;
    for (const MasterStatus::Segment &segment : master.segments) {
        if (segment.switchedOff)
            text += CommandLine::tr("Segment %1:      switched off").arg(segment.segment) + u'\n';
        if (segment.crcErrors > 0)
            text += CommandLine::tr("Segment %1:      CRC errors: %2")
                        .arg(segment.segment)
                        .arg(segment.crcErrors) +
                    u'\n';
    }
    return text;
}

} // namespace

QString masterLines(const RingSession &bus)
{
    const MasterStatus *master = bus.master();
    if (!master)
        return CommandLine::tr("Master:         not reached by this link") + u'\n';
    const QString fault = masterFaultText(*master);
    return CommandLine::tr("Master:         %1").arg(masterStateName(master->state)) + u'\n' +
           CommandLine::tr("Status:         %1 (%2)")
               .arg(hexCode(master->statusBits, 4), bitNames(master->statusBits)) +
           u'\n' + CommandLine::tr("Fault:          %1").arg(fault) + u'\n' +
           CommandLine::tr("Configuration:  %1")
               .arg(master->configurationName.value_or(CommandLine::tr("none"))) +
           u'\n' + segmentLines(*master);
}

QJsonValue masterJson(const RingSession &bus)
{
    const MasterStatus *master = bus.master();
    if (!master)
        return {};
    QJsonArray segments;
    for (const MasterStatus::Segment &segment : master->segments)
        segments.append(QJsonObject{{QStringLiteral("segment"), segment.segment},
                                    {QStringLiteral("on"), !segment.switchedOff},
                                    {QStringLiteral("crcErrors"), static_cast<qint64>(segment.crcErrors)}});
    return QJsonObject{{QStringLiteral("state"), keyOf(masterStateKeys, master->state)},
                       {QStringLiteral("status"), hex(master->statusBits)},
                       {QStringLiteral("errorCode"), hex(master->errorCode)},
                       {QStringLiteral("parameter"), hex(master->parameter)},
                       {QStringLiteral("fault"), placeJson(master->faultPlace())},
                       {QStringLiteral("configuration"),
                        master->configurationName ? QJsonValue(*master->configurationName) : QJsonValue()},
                       {QStringLiteral("segments"), segments},
                       {QStringLiteral("devices"), devicesJson(bus, *master)}};
}

} // namespace codewheel
