// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bus/present_ports.h"
#include "cli/call/texts.h"
#include "cli/kinds/interbus/gateway_link_text.h"
#include "cli/kinds/interbus/ring_link_kind.h"
#include "kinds/interbus/finder/gateway_host_finder.h"
#include "kinds/interbus/links/modbus_port.h"
#include "kinds/interbus/plan/gateway_plan.h"
#include "kinds/interbus/plan/ring_plan.h"
#include "kinds/interbus/words/device_number.h"

#include <array>

namespace codewheel {
namespace {

constexpr std::array gatewayCommands{&gatewayCommand};

std::vector<BusId> ringsOf(const Project &project)
{
    std::vector<BusId> rings;
    for (const PlannedBus &bus : project.buses)
        if (bus.kind == QLatin1String(interbusKind))
            rings.push_back(bus.id);
    return rings;
}

bool isAt(const Project &project, BusId ring, const GatewaySettings &gateway)
{
    const auto planned = plannedGateway(project, ring);
    return planned && *planned && gatewayUnit(**planned) == gatewayUnit(gateway);
}

// The ring of the project behind this gateway: the one that has it, otherwise the only one.
Checked<std::optional<BusId>> ringAt(const Project *project, const GatewaySettings &gateway)
{
    const std::vector<BusId> rings = project != nullptr ? ringsOf(*project) : std::vector<BusId>();
    for (const BusId ring : rings)
        if (isAt(*project, ring, gateway))
            return ring;
    if (rings.size() == 1)
        return rings.front();
    if (rings.empty())
        return std::nullopt;
    return badInput("ringNotUnique",
                    CommandLine::tr("The project has several rings, and none of them is planned at %1. Give "
                                    "it to one of them in the project, and use --link project."),
                    {gatewayUnit(gateway)});
}

// Rings behind a gateway at the command line.
class GatewayLinkKind final : public LinkKind
{
public:
    QString bus() const override { return QString::fromLatin1(interbusKind); }
    QStringList schemes() const override
    {
        return {QString::fromLatin1(modbusTcpLink), QString::fromLatin1(modbusRtuLink)};
    }
    bool leadsToPlanned() const override { return false; } // interbus:project does
    QString help() const override
    {
        return CommandLine::tr("modbus-tcp:HOST[:PORT] and modbus-rtu:PORT, a gateway that shows the ring of "
                               "the project as registers, as modbus-tcp:192.168.0.5,unit=1");
    }
    bool isPlace(const QString &typed) const override { return DeviceNumber::parse(typed).has_value(); }
    Checked<std::vector<MakeLink>> links(const LinkText &text, const Project *project) const override
    {
        return gatewayMeant(text).and_then([&](const GatewaySettings &gateway) {
            return ringAt(project, gateway).map([&](std::optional<BusId> ring) {
                return std::vector{ringBehind(gateway, project, numberOf(*this, project, ring))};
            });
        });
    }
    // Those of the project are planned by the kind of the ring.
    Checked<MakeLink> planned(const Project &, BusId, const QStringList &) const override
    {
        return MakeLink();
    }
    MakeLink training(const Project *) const override { return {}; }
    Checked<std::optional<HostSearch>> hostSearch(const QString &typed) const override
    {
        return gatewayMeant({QString::fromLatin1(modbusTcpLink), typed, {}})
            .map([](const GatewaySettings &host) {
                return std::optional(
                    HostSearch{gatewayAddress(host), GatewayHostFinder::announcement(),
                               std::make_unique<GatewayHostFinder>(host, [](const GatewaySettings &settings) {
                                   return std::make_unique<ModbusPort>(settings);
                               })});
            });
    }
    std::span<const Subcommand *const> commands() const override { return gatewayCommands; }
    QStringList ends(const QString &scheme) const override
    {
        return scheme == QLatin1String(modbusRtuLink) ? presentPortNames() : QStringList();
    }
    QStringList settingKeys(const QString &scheme) const override;
};

QStringList GatewayLinkKind::settingKeys(const QString &scheme) const
{
    GatewaySettings settings;
    if (scheme == QLatin1String(modbusRtuLink))
        settings.transport = GatewaySettings::Transport::rtu;
    QStringList keys;
    for (const auto &[key, value] : allSettingTexts(settings))
        keys << key;
    return keys;
}

} // namespace

MakeLink ringBehind(const GatewaySettings &gateway, const Project *project, BusId ring)
{
    const auto its = project != nullptr ? std::make_shared<const Project>(*project) : nullptr;
    return [gateway, its, ring](const Catalog &catalog) {
        return Checked<std::unique_ptr<BusAccess>>(
            std::make_unique<GatewayAccess>(gateway, its.get(), ring, catalog));
    };
}

std::unique_ptr<const LinkKind> gatewayLinkKind()
{
    return std::make_unique<GatewayLinkKind>();
}

} // namespace codewheel
