// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/ring/ring_link_kind.h"

#include "cli/ring/ring_access.h"
#include "cli/texts.h"
#include "encoder/device_number.h"
#include "project/ring_plan.h"
#include "simulator/fault_plan_file.h"
#include "training_session.h"

#include <array>

namespace codewheel {
namespace {

constexpr std::array ringCommands{&masterCommand};

Checked<std::unique_ptr<BusAccess>> makeTraining(const Catalog &catalog, const Arguments &arguments, BusId id)
{
    TrainingSession training = openTrainingSession(catalog, QDateTime::currentDateTime(), id);
    if (const auto path = arguments.value("--fault-plan")) {
        auto plan = loadFaultPlan(*path, training.controls->places());
        if (!plan)
            return tl::unexpected(complaintAbout(plan.error()));
        training.controls->startFaultPlan(*std::move(plan));
    }
    return std::make_unique<RingAccess>(std::move(training.bus), std::move(training.controls));
}

MakeLink trainingRing(BusId id)
{
    return [id](const Catalog &catalog, const Arguments &arguments) {
        return makeTraining(catalog, arguments, id);
    };
}

} // namespace

QString RingLinkKind::bus() const
{
    return QString::fromLatin1(interbusKind);
}

QStringList RingLinkKind::schemes() const
{
    return {bus()};
}

QString RingLinkKind::help() const
{
    return CommandLine::tr("interbus:training, the simulated ring alone");
}

bool RingLinkKind::isPlace(const QString &typed) const
{
    return DeviceNumber::parse(typed).has_value();
}

Checked<std::vector<MakeLink>> RingLinkKind::links(const LinkText &text, const Project *project) const
{
    if (text.where == QStringLiteral("training") && text.settings.isEmpty())
        return std::vector{training(project)};
    return badInput(QStringLiteral("unknownLink"),
                    CommandLine::tr("There is no link \"%1\". The links are: %2."),
                    {(QStringList{text.scheme + u':' + text.where} + text.settings).join(u','), help()});
}

MakeLink RingLinkKind::planned(const Project &project, BusId bus) const
{
    const ProjectLink &link = ringPlan(project, bus).link;
    if (link.kind == ProjectLink().kind)
        return trainingRing(bus);
    return [name = findBus(project, bus)->name, link](const Catalog &, const Arguments &) {
        return Checked<std::unique_ptr<BusAccess>>(
            badInput(QStringLiteral("noSuchLink"),
                     CommandLine::tr("The project links \"%1\" by \"%2\": this program has no such link."),
                     {name, link.kind}));
    };
}

MakeLink RingLinkKind::training(const Project *project) const
{
    return trainingRing(numberOf(*this, project));
}

std::span<const Subcommand *const> RingLinkKind::commands() const
{
    return ringCommands;
}

} // namespace codewheel
