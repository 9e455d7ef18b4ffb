// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/kinds/esc/esc_line_link_kind.h"

#include "catalog/device_description.h"
#include "catalog/value_text.h"
#include "cli/bus/places.h"
#include "cli/bus/present_ports.h"
#include "cli/call/texts.h"
#include "cli/kinds/esc/device_on_line.h"
#include "cli/kinds/esc/esc_line_access.h"
#include "cli/kinds/esc/scan_line.h"
#include "kinds/esc/protocol/esc_forms.h"
#include "kinds/esc/protocol/esc_profile.h"
#include "kinds/esc/simulator/simulated_esc_line.h"
#include "links/port_access.h"
#include "project/bus_kind.h"
#include "project/bus_plans.h"

#include <array>

namespace codewheel {
namespace {

constexpr std::array lineCommands{&terminalCommand};

std::vector<BusId> linesOf(const Project &project)
{
    std::vector<BusId> lines;
    for (const PlannedBus &bus : project.buses)
        if (bus.kind == QLatin1String(escKind))
            lines.push_back(bus.id);
    return lines;
}

// Whose port it is in the project. Empty: it may belong to its only line; with several lines it belongs to
// none.
std::optional<BusId> lineAtPort(const Project *project, const QString &port)
{
    const std::vector<BusId> lines = project != nullptr ? linesOf(*project) : std::vector<BusId>();
    for (const BusId line : lines)
        if (isSamePort(linePlan(*project, line)->settings.port, port))
            return line;
    const bool isPort = port != QStringLiteral("training");
    return lines.size() > 1 && isPort
               ? std::optional(freeNumber(*project, *busKind(QString::fromLatin1(escKind))))
               : std::nullopt;
}

MakeLink lineTo(const EscLineLink &link, BusId id)
{
    return [link, id](const Catalog &catalog) {
        return Checked<std::unique_ptr<BusAccess>>(EscLineAccess::to(link, catalog, id));
    };
}

// Serial lines with the ESC protocol at the command line: a port, or the training line.
class EscLineLinkKind final : public LinkKind
{
public:
    QString bus() const override { return QString::fromLatin1(escKind); }
    QStringList schemes() const override { return {QStringLiteral("esc")}; }
    QString help() const override
    {
        return CommandLine::tr("esc:training, the simulated line alone; esc:PORT, a serial line with Kübler "
                               "encoders, as esc:ttyUSB0,baud=9600");
    }
    bool isPlace(const QString &typed) const override { return addressTyped(typed).has_value(); }
    Checked<std::vector<MakeLink>> links(const LinkText &text, const Project *project) const override;
    Checked<MakeLink> planned(const Project &project, BusId bus, const QStringList &settings) const override
    {
        return lineOf(project, bus, settings).map([bus](const EscLineLink &link) {
            return lineTo(link, bus);
        });
    }
    MakeLink training(const Project *project) const override { return lineTo({}, numberOf(*this, project)); }
    std::span<const Subcommand *const> commands() const override { return lineCommands; }
    std::span<const Option> scanOptions() const override { return scanLineOptions; }
    std::span<const Service> services() const override { return {&lineService, 1}; }
    QStringList ends(const QString &) const override
    {
        return QStringList{QStringLiteral("training")} + presentPortNames();
    }
    QStringList settingKeys(const QString &) const override { return lineSettingKeys(); }
    std::vector<KnownDevice> trainingDevices(const Catalog &catalog) const override;
    std::optional<Checked<Answer>> explain(const Call &call, const DeviceDescription &device) const override
    {
        return device.profile == profile::esc ? std::optional(explainLine(call, device)) : std::nullopt;
    }
    Checked<DeviceDescription> asOnLink(const Call &call, DeviceDescription device) const override;
};

Checked<std::vector<MakeLink>> EscLineLinkKind::links(const LinkText &text, const Project *project) const
{
    const BusId id = numberOf(*this, project, lineAtPort(project, text.where));
    return lineMeant(text, project, id).map([id](const EscLineLink &link) {
        return std::vector{lineTo(link, id)};
    });
}

std::vector<KnownDevice> EscLineLinkKind::trainingDevices(const Catalog &) const
{
    std::vector<KnownDevice> devices;
    for (const EscEncoderPlan &encoder : trainingLine())
        devices.push_back({encoder.address.node().toString(), usualDeviceOnLine()});
    return devices;
}

// With the limits of a scaling factor in the format of the line.
Checked<DeviceDescription> EscLineLinkKind::asOnLink(const Call &call, DeviceDescription device) const
{
    if (device.profile != profile::esc || busesOf(call, bus()).empty())
        return device;
    const auto line = busMeant(call, bus());
    if (!line)
        return tl::unexpected(line.error());
    const int bits = static_cast<const EscLineAccess &>(**line).link().settings.fractionBits; // of its kind
    for (ParameterDescription &parameter : device.parameters)
        parameter = withOptions(parameter, KindData(EscValueOptions{.fractionBits = bits}));
    return device;
}

} // namespace

std::unique_ptr<const LinkKind> lineLinkKind()
{
    return std::make_unique<EscLineLinkKind>();
}

} // namespace codewheel
