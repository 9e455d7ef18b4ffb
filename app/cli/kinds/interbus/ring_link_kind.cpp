// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/kinds/interbus/ring_link_kind.h"

#include "catalog/device_description.h"
#include "cli/call/texts.h"
#include "cli/kinds/interbus/gateway_link_text.h"
#include "cli/kinds/interbus/ring_access.h"
#include "kinds/interbus/plan/gateway_plan.h"
#include "kinds/interbus/plan/ring_plan.h"
#include "kinds/interbus/simulator/training_bus.h"
#include "kinds/interbus/words/device_number.h"

#include <array>

namespace codewheel {
namespace {

constexpr std::array ringCommands{&masterCommand};

Checked<void> checkHasNoSettings(const QString &link, const QStringList &settings)
{
    if (settings.isEmpty())
        return {};
    return badInput("linkWithoutSettings", CommandLine::tr("The link %1 has no settings. Leave \"%2\" out."),
                    {link, settings.join(u',')});
}

MakeLink trainingRing(BusId id)
{
    return [id](const Catalog &catalog) -> Checked<std::unique_ptr<BusAccess>> {
        return std::make_unique<RingAccess>(openTrainingSession(catalog, QDateTime::currentDateTime(), id));
    };
}

// INTERBUS at the command line: the training ring, and the rings of the project.
class RingLinkKind final : public LinkKind
{
public:
    QString bus() const override { return QString::fromLatin1(interbusKind); }
    QStringList schemes() const override { return {bus()}; }
    QString help() const override { return CommandLine::tr("interbus:training, the simulated ring alone"); }
    bool isPlace(const QString &typed) const override { return DeviceNumber::parse(typed).has_value(); }
    Checked<std::vector<MakeLink>> links(const LinkText &text, const Project *project) const override;
    Checked<MakeLink> planned(const Project &project, BusId bus, const QStringList &settings) const override;
    MakeLink training(const Project *project) const override
    {
        return trainingRing(numberOf(*this, project));
    }
    std::span<const Subcommand *const> commands() const override { return ringCommands; }
    std::span<const Service> services() const override { return modbusServices(); }
    QStringList ends(const QString &) const override { return {QStringLiteral("training")}; }
    std::vector<KnownDevice> trainingDevices(const Catalog &catalog) const override;
};

std::vector<KnownDevice> RingLinkKind::trainingDevices(const Catalog &catalog) const
{
    std::vector<KnownDevice> devices;
    for (const TrainingParticipant &participant : trainingPlan(catalog))
        if (participant.device != nullptr)
            devices.push_back({participant.number.toString(), participant.device->key});
    return devices;
}

Checked<std::vector<MakeLink>> RingLinkKind::links(const LinkText &text, const Project *project) const
{
    if (text.where != QStringLiteral("training"))
        return unknownLink(text.link());
    return checkHasNoSettings(text.link(), text.settings).map([&] { return std::vector{training(project)}; });
}

Checked<MakeLink> RingLinkKind::planned(const Project &project, BusId bus, const QStringList &settings) const
{
    const ProjectLink &link = ringPlan(project, bus).link;
    if (const auto gateway = plannedGateway(project, bus))
        return gateway->map_error(complaintAbout)
            .and_then([&](const GatewaySettings &its) { return withSettings(its, settings); })
            .map([&](const GatewaySettings &its) { return ringBehind(its, &project, bus); });
    if (const auto checked = checkHasNoSettings(QStringLiteral("interbus:project"), settings); !checked)
        return tl::unexpected(checked.error());
    if (link.kind == ProjectLink().kind)
        return trainingRing(bus);
    return [name = findBus(project, bus)->name, link](const Catalog &) {
        return Checked<std::unique_ptr<BusAccess>>(
            badInput("noSuchLink",
                     CommandLine::tr("The project links \"%1\" by \"%2\": this program has no such link."),
                     {name, link.kind}));
    };
}

} // namespace

std::unique_ptr<const LinkKind> ringLinkKind()
{
    return std::make_unique<RingLinkKind>();
}

} // namespace codewheel
