// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/catalog.h"
#include "catalog/hex_code.h"
#include "cli/commands.h"
#include "cli/device_text.h"
#include "cli/json.h"
#include "cli/text_table.h"
#include "cli/texts.h"
#include "ring/bus_session.h"

namespace codewheel {
namespace {

constexpr const char *examples[] = {"scan", "scan --json"};

// The ID code tells the profile, never the make of an encoder; that is the plan's to name.
QString makeOf(const Participant &participant, const DeviceDescription *named)
{
    return named || participant.idCode == busTerminalIdCode ? participantName(participant, named)
                                                            : CommandLine::tr("make not known");
}

Checked<Answer> run(const Call &call)
{
    using enum TextTable::Align;
    TextTable table({left, left, left, right, right});
    table.add({CommandLine::tr("place"), CommandLine::tr("ID code"), CommandLine::tr("device code"),
               CommandLine::tr("IN words"), CommandLine::tr("OUT words"), CommandLine::tr("profile"),
               CommandLine::tr("device")});
    QJsonArray devices;
    for (const Participant &participant : call.bus->structure()) {
        const DeviceDescription *named = call.catalog.find(participant.deviceKey);
        const DeviceDescription *known = named ? named : call.catalog.generic(participant.deviceCode);
        const QString profile = known ? profileName(known->profile) : QStringLiteral("-");
        table.add({participant.number.toString(),
                   QStringLiteral("%1 (%2)").arg(hexCode(participant.idCode, 2)).arg(participant.idCode),
                   hexCode(participant.deviceCode, 4), QString::number(participant.inWords),
                   QString::number(participant.outWords), profile, makeOf(participant, named)});
        devices.append(
            QJsonObject{{QStringLiteral("place"), participant.number.toString()},
                        {QStringLiteral("idCode"), static_cast<int>(participant.idCode)},
                        {QStringLiteral("deviceCode"), static_cast<int>(participant.deviceCode)},
                        {QStringLiteral("inWords"), participant.inWords},
                        {QStringLiteral("outWords"), participant.outWords},
                        {QStringLiteral("profile"), known ? QJsonValue(profile) : QJsonValue()},
                        {QStringLiteral("device"), named ? QJsonValue(named->key) : QJsonValue()}});
    }
    return Answer{table.toString(), {{QStringLiteral("participants"), devices}}};
}

} // namespace

const Subcommand scanCommand{
    .name = "scan",
    .usage = "",
    .summary = QT_TRANSLATE_NOOP("codewheel::CommandLine", "list the participants of the bus"),
    .details = QT_TRANSLATE_NOOP("codewheel::CommandLine",
                                 "Lists the participants of the bus in ring order, with their ID codes and "
                                 "words (16 bit each).\nThe ID code tells the profile but not the make: that "
                                 "is named where the plan of the bus tells it.\nSends nothing."),
    .examples = examples,
    .options = {},
    .minimumArguments = 0,
    .maximumArguments = 0,
    .needsBus = true,
    .run = run,
};

} // namespace codewheel
