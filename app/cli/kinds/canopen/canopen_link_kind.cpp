// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/kinds/canopen/canopen_link_kind.h"

#include "catalog/device_description.h"
#include "cli/bus/present_ports.h"
#include "cli/call/texts.h"
#include "cli/kinds/canopen/canopen_access.h"
#include "cli/kinds/canopen/canopen_scan.h"
#include "cli/kinds/canopen/device_file_check.h"
#include "cli/kinds/canopen/device_on_node.h"
#include "kinds/canopen/finder/can_interface_finder.h"
#include "kinds/canopen/simulator/simulated_canopen_plant.h"
#include "links/can_interface.h"
#include "links/can_link_to.h"

#include <array>

namespace codewheel {
namespace {

constexpr std::array canopenCommands{&odCommand, &nmtCommand, &lssCommand, &edsCommand};

MakeLink canBusAt(const CanopenLink &link, BusId id)
{
    return [link, id](const Catalog &catalog) {
        return Checked<std::unique_ptr<BusAccess>>(CanopenAccess::to(link, catalog, id));
    };
}

// CAN buses with CANopen at the command line: an interface, a serial adapter, or the training bus.
class CanopenLinkKind final : public LinkKind
{
public:
    QString bus() const override { return QString::fromLatin1(canopenKind); }
    QStringList schemes() const override
    {
        return {QStringLiteral("can"), QStringLiteral("slcan"), QStringLiteral("canopen")};
    }
    QString help() const override
    {
        return CommandLine::tr("can:INTERFACE, a CAN bus with CANopen, as can:can0; slcan:PORT, the same "
                               "through a serial adapter, as slcan:ttyACM0,rate=250000; canopen:training, "
                               "the simulated CAN bus");
    }
    bool isPlace(const QString &typed) const override { return CanopenAddress::read(typed).has_value(); }
    Checked<std::vector<MakeLink>> links(const LinkText &text, const Project *project) const override
    {
        return canopenLinkMeant(text).map([&](const CanopenLink &link) {
            return std::vector{canBusAt(link, numberOf(*this, project, busAt(link, project)))};
        });
    }
    Checked<MakeLink> planned(const Project &project, BusId bus, const QStringList &settings) const override
    {
        return canopenLinkOf(project, bus, settings).map([bus](const CanopenLink &link) {
            return canBusAt(link, bus);
        });
    }
    MakeLink training(const Project *project) const override
    {
        return canBusAt({}, numberOf(*this, project));
    }
    std::span<const Subcommand *const> commands() const override { return canopenCommands; }
    std::span<const Option> scanOptions() const override { return scanCanOptions; }
    std::span<const Service> services() const override { return {&canBusService, 1}; }
    QStringList ends(const QString &scheme) const override;
    QStringList settingKeys(const QString &scheme) const override { return canopenSettingKeys(scheme); }
    std::vector<KnownDevice> trainingDevices(const Catalog &catalog) const override;
    std::optional<Answer> checkDeviceFile(const Call &call, const QString &path) const override
    {
        return isCanopenDeviceFile(path) ? std::optional(checkOfDeviceFile(call, path)) : std::nullopt;
    }
    std::vector<std::unique_ptr<PlaceFinder>> listenersAt(const QString &typed) const override;

private:
    // The bus of the project that has this link. Empty: none.
    static std::optional<BusId> busAt(const CanopenLink &link, const Project *project)
    {
        if (project != nullptr && !link.isSimulated())
            for (const PlannedBus &bus : project->buses)
                if (const CanopenPlan *plan = canopenPlan(*project, bus.id);
                    plan != nullptr && plan->settings.link == link.settings.link)
                    return bus.id;
        return std::nullopt;
    }
};

QStringList CanopenLinkKind::ends(const QString &scheme) const
{
    if (scheme == QStringLiteral("slcan"))
        return presentPortNames();
    if (scheme == QStringLiteral("canopen"))
        return {QStringLiteral("training")};
    QStringList names;
    for (const CanInterface &interface : canInterfaces(Computer(), {}))
        names << interface.name;
    return names;
}

std::vector<KnownDevice> CanopenLinkKind::trainingDevices(const Catalog &) const
{
    std::vector<KnownDevice> devices;
    for (const canopen::CanopenEncoderPlan &encoder : canopen::trainingEncoders())
        if (encoder.node)
            devices.push_back({CanopenAddress{*encoder.node}.place().toString(), usualDeviceOnNode()});
    return devices;
}

// Interfaces of the system.
std::vector<std::unique_ptr<PlaceFinder>> CanopenLinkKind::listenersAt(const QString &typed) const
{
    std::vector<std::unique_ptr<PlaceFinder>> listeners;
    for (const CanInterface &interface : canInterfaces(Computer(), {}))
        if (typed.isEmpty() || typed == interface.name)
            listeners.push_back(std::make_unique<CanInterfaceFinder>(canLinkTo({.where = interface.name})));
    return listeners;
}

} // namespace

std::unique_ptr<const LinkKind> canopenLinkKind()
{
    return std::make_unique<CanopenLinkKind>();
}

} // namespace codewheel
