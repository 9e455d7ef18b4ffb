// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/line/line_link_kind.h"

#include "catalog/device_description.h"
#include "catalog/value_text.h"
#include "cli/line/explain_line.h"
#include "cli/line/line_access.h"
#include "cli/line/scan_line.h"
#include "cli/texts.h"
#include "links/port_access.h"
#include "project/bus_kind.h"
#include "project/bus_plans.h"

#include <array>

namespace codewheel {
namespace {

constexpr std::array lineCommands{&terminalCommand, &serveCommand};

std::vector<BusId> linesOf(const Project &project)
{
    std::vector<BusId> lines;
    for (const PlannedBus &bus : project.buses)
        if (bus.kind == QLatin1String(escKind))
            lines.push_back(bus.id);
    return lines;
}

// Whose port it is in the project. Nothing: it may be that of its only line; of several it is none.
std::optional<BusId> lineAtPort(const Project *project, const QString &port)
{
    const std::vector<BusId> lines = project != nullptr ? linesOf(*project) : std::vector<BusId>();
    for (const BusId line : lines)
        if (portPath(linePlan(*project, line)->wish.port) == portPath(port))
            return line;
    const bool isPort = port != QStringLiteral("training");
    return lines.size() > 1 && isPort
               ? std::optional(freeNumber(*project, *busKind(QString::fromLatin1(escKind))))
               : std::nullopt;
}

MakeLink lineTo(const LineLink &link, BusId id)
{
    return [link, id](const Catalog &catalog, const Arguments &) {
        return Checked<std::unique_ptr<BusAccess>>(LineAccess::to(link, catalog, id));
    };
}

} // namespace

QString LineLinkKind::bus() const
{
    return QString::fromLatin1(escKind);
}

QStringList LineLinkKind::schemes() const
{
    return {QStringLiteral("esc")};
}

QString LineLinkKind::help() const
{
    return CommandLine::tr("esc:PORT, a serial line with Kübler encoders, as esc:ttyUSB0,baud=9600");
}

bool LineLinkKind::isPlace(const QString &typed) const
{
    return addressTyped(typed).has_value();
}

Checked<std::vector<MakeLink>> LineLinkKind::links(const LinkText &text, const Project *project) const
{
    std::vector<BusId> lines;
    if (text.where == QStringLiteral("project") && project != nullptr)
        lines = linesOf(*project);
    if (lines.empty())
        lines.push_back(numberOf(*this, project, lineAtPort(project, text.where)));
    std::vector<MakeLink> links;
    for (const BusId id : lines) {
        const auto link = lineMeant(text, project, id);
        if (!link)
            return tl::unexpected(link.error());
        links.push_back(lineTo(*link, id));
    }
    return links;
}

MakeLink LineLinkKind::planned(const Project &project, BusId bus) const
{
    const auto link = lineOf(&project, bus);
    return lineTo(link ? *link : LineLink{.whyNot = link.error()}, bus); // the other buses can be used
}

MakeLink LineLinkKind::training(const Project *project) const
{
    return lineTo({}, numberOf(*this, project));
}

std::span<const Subcommand *const> LineLinkKind::commands() const
{
    return lineCommands;
}

std::span<const Option> LineLinkKind::scanOptions() const
{
    return scanLineOptions;
}

std::optional<Checked<Answer>> LineLinkKind::explain(const Call &call, const DeviceDescription &device) const
{
    return device.profile == Profile::esc ? std::optional(explainLine(call, device)) : std::nullopt;
}

// With the limits of a scaling factor in the format of the line.
Checked<DeviceDescription> LineLinkKind::asOnLink(const Call &call, DeviceDescription device) const
{
    const auto line = lineOfCall(call);
    if (!line)
        return tl::unexpected(line.error());
    for (ParameterDescription &parameter : device.parameters)
        parameter = atFractionBits(parameter, line->wish.fractionBits);
    return device;
}

} // namespace codewheel
