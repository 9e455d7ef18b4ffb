// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bus/bus_access.h"
#include "cli/call/json.h"
#include "cli/call/texts.h"
#include "cli/commands.h"
#include "doctor/doctor.h"
#include "vocabulary/sentence.h"

#include <QJsonArray>

#include <algorithm>

namespace codewheel {
namespace {

constexpr const char *doctorExamples[] = {"doctor", "doctor --link esc:ttyUSB0",
                                          "doctor --link modbus-tcp:192.168.0.5 --json"};

// Of the links of the call first, then of the rest of the computer.
Hindrances hindrancesOf(const Call &call, const std::vector<PortInfo> &ports)
{
    Hindrances all;
    for (const BusAccess *link : call.links)
        for (Hindrance &one : link->hindrances())
            all.push_back(std::move(one));
    for (Hindrance &one : examine(ports))
        if (std::ranges::find(all, one) == all.end())
            all.push_back(std::move(one));
    return all;
}

QString textOf(const Hindrances &hindrances, const std::vector<PortInfo> &ports)
{
    QString text;
    if (std::ranges::all_of(hindrances,
                            [](const Hindrance &one) { return one.weight == Hindrance::Weight::remark; }))
        text += CommandLine::tr("Nothing was found that keeps a link from working.") + u'\n';
    for (const Hindrance &one : hindrances) {
        text += one.sentence + u'\n' + commandToCopy(one.command);
    }
    QStringList labels;
    for (const PortInfo &port : ports)
        labels << port.label();
    if (!labels.isEmpty())
        text += sentence(CommandLine::tr("The ports there are: %1."), {labels.join(QStringLiteral("; "))}) +
                u'\n';
    return text;
}

QJsonObject hindranceJson(const Hindrance &one)
{
    return {{QStringLiteral("id"), hindranceKey(one.id)},
            {QStringLiteral("weight"), weightKey(one.weight)},
            {QStringLiteral("about"), textJson(one.about)},
            {QStringLiteral("text"), one.sentence},
            {QStringLiteral("command"), textJson(one.command)}};
}

QJsonObject portJson(const PortInfo &port)
{
    return {{QStringLiteral("port"), port.path},
            {QStringLiteral("description"), textJson(port.description)},
            {QStringLiteral("serialNumber"), textJson(port.serialNumber)}};
}

QJsonObject doctorJson(const Hindrances &hindrances, const std::vector<PortInfo> &ports)
{
    QJsonArray found;
    for (const Hindrance &one : hindrances)
        found.append(hindranceJson(one));
    QJsonArray there;
    for (const PortInfo &port : ports)
        there.append(portJson(port));
    return {{QStringLiteral("hindrances"), found}, {QStringLiteral("ports"), there}};
}

Checked<Answer> run(const Call &call)
{
    const std::vector<PortInfo> ports = serialPorts();
    const Hindrances hindrances = hindrancesOf(call, ports);
    Answer answer{textOf(hindrances, ports), doctorJson(hindrances, ports)};
    if (std::ranges::find(hindrances, Hindrance::Weight::prevents, &Hindrance::weight) != hindrances.end())
        answer.complaint =
            notDone("linkHindered", CommandLine::tr("Something keeps a link from working: see above."));
    return answer;
}

} // namespace

const Subcommand doctorCommand{
    .name = "doctor",
    .usage = "",
    .summary = QT_TRANSLATE_NOOP("codewheel::CommandLine", "what keeps a link from working, and what to do"),
    .details = QT_TRANSLATE_NOOP(
        "codewheel::CommandLine",
        "Looks for what keeps ports and links from working: missing rights, a port that another program\n"
        "has, an adapter without a driver or taken by brltty, ModemManager, a slow adapter, a CAN interface\n"
        "that is switched off. With --link also for what is in the way of this link; a Modbus/TCP gateway\n"
        "is connected and left again. To each it says what to do, with a command to copy. Opens no serial\n"
        "port and sends nothing to an encoder. Ends with 1 if something prevents a link, else with 0."),
    .examples = doctorExamples,
    .options = {},
    .arguments = {0},
    .needsLinks = true,
    .run = run,
};

} // namespace codewheel
