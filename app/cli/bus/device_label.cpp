// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bus/device_label.h"

#include "catalog/catalog.h"
#include "catalog/hex_code.h"
#include "catalog/label_key.h"
#include "cli/call/json.h"
#include "cli/call/text_table.h"
#include "cli/call/texts.h"
#include "user_devices.h"
#include "vocabulary/refusal_text.h"

#include <QJsonArray>

namespace codewheel {
namespace {

QString matchLines(const std::vector<LabelMatch> &matches)
{
    TextTable table;
    for (const LabelMatch &match : matches)
        table.add({match.device->key, profileName(match.device->profile),
                   match.device->deviceCode == 0 ? QStringLiteral("-") : hexCode(match.device->deviceCode, 4),
                   match.device->fullName()});
    QString text = table.toString();
    if (matches.size() > 1)
        text +=
            CommandLine::tr("One of these: the key does not say which. The device code on the bus does.") +
            u'\n';
    return text;
}

QString resolutionLine(const LabelMatch &match)
{
    if (match.turns == 0 || match.stepsPerTurn == 0)
        return CommandLine::tr("Turns and steps per turn: not stated.");
    const QString text =
        CommandLine::tr("Turns: %1, steps per turn: %2").arg(match.turns).arg(match.stepsPerTurn);
    return match.reading.turns && match.reading.stepsPerTurn
               ? text
               : text + CommandLine::tr(" (from the description: the key does not state them)");
}

} // namespace

Checked<Answer> labelAnswer(const Catalog &catalog, const QString &typed)
{
    const auto matches = findByLabel(catalog, typed);
    if (!matches)
        return tl::unexpected(complaintAbout(matches.error()));
    const LabelMatch &first = matches->front();
    TextTable table;
    QJsonArray parts;
    for (const LabelReading::Part &part : first.reading.parts) {
        table.add({part.name.toString(), part.written, part.meaning.toString()});
        parts.append(QJsonObject{{QStringLiteral("name"), part.name.toString()},
                                 {QStringLiteral("written"), part.written},
                                 {QStringLiteral("meaning"), part.meaning.toString()}});
    }
    QJsonArray devices;
    for (const LabelMatch &match : *matches)
        devices.append(QJsonObject{{QStringLiteral("name"), match.device->key},
                                   {QStringLiteral("profile"), profileName(match.device->profile)},
                                   {QStringLiteral("deviceCode"), knownJson(match.device->deviceCode)},
                                   {QStringLiteral("turns"), knownJson(match.turns)},
                                   {QStringLiteral("stepsPerTurn"), knownJson(match.stepsPerTurn)}});
    return Answer{table.toString() + resolutionLine(first) + QStringLiteral("\n\n") + matchLines(*matches),
                  {{QStringLiteral("label"), typed},
                   {QStringLiteral("parts"), parts},
                   {QStringLiteral("devices"), devices}}};
}

Answer checkAnswer(const QString &path)
{
    Catalog catalog = Catalog::builtIn();
    addUserDevices(catalog, userDeviceFolder(), path);
    const std::size_t before = catalog.devices().size();
    Answer answer;
    if (const auto added = addDeviceFile(catalog, path); !added) {
        const Catalog::Fault &fault = added.error();
        answer.json = {{QStringLiteral("file"), fault.file},
                       {QStringLiteral("line"), knownJson(fault.line)},
                       {QStringLiteral("faultKey"), fault.key},
                       {QStringLiteral("reason"), fault.reason}};
        answer.complaint = Complaint{ExitCode::badInput,
                                     refusalKey(RefusalId::deviceFileBroken),
                                     QStringLiteral("%1: %2").arg(fault.place(), fault.reason),
                                     {fault.place(), fault.reason}};
        return answer;
    }
    const DeviceDescription &device = catalog.devices()[before];
    answer.text = CommandLine::tr("%1 is valid: %2 (%3)").arg(path, device.fullName(), device.key) + u'\n';
    answer.json = {{QStringLiteral("file"), path}, {QStringLiteral("name"), device.key}};
    return answer;
}

} // namespace codewheel
