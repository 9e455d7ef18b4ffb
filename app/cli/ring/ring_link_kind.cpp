// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/ring/ring_link_kind.h"

#include "cli/ring/ring_access.h"
#include "cli/texts.h"
#include "encoder/device_number.h"
#include "project/ring_plan.h"

#include <array>

namespace codewheel {
namespace {

constexpr std::array ringCommands{&masterCommand};

MakeLink trainingRing(BusId id)
{
    return [id](const Catalog &catalog) -> Checked<std::unique_ptr<BusAccess>> {
        return std::make_unique<RingAccess>(openTrainingSession(catalog, QDateTime::currentDateTime(), id));
    };
}

// INTERBUS at the command line: the training ring.
class RingLinkKind final : public LinkKind
{
public:
    QString bus() const override { return QString::fromLatin1(interbusKind); }
    QStringList schemes() const override { return {bus()}; }
    QString help() const override { return CommandLine::tr("interbus:training, the simulated ring alone"); }
    bool isPlace(const QString &typed) const override { return DeviceNumber::parse(typed).has_value(); }
    Checked<std::vector<MakeLink>> links(const LinkText &text, const Project *project) const override;
    MakeLink planned(const Project &project, BusId bus) const override;
    MakeLink training(const Project *project) const override
    {
        return trainingRing(numberOf(*this, project));
    }
    std::span<const Subcommand *const> commands() const override { return ringCommands; }
};

Checked<std::vector<MakeLink>> RingLinkKind::links(const LinkText &text, const Project *project) const
{
    const QString link = text.scheme + u':' + text.where;
    if (text.where != QStringLiteral("training"))
        return badInput(QStringLiteral("unknownLink"),
                        CommandLine::tr("There is no link \"%1\". The links are: %2."), {link, help()});
    if (!text.settings.isEmpty())
        return badInput(QStringLiteral("linkWithoutSettings"),
                        CommandLine::tr("The link %1 has no settings. Leave \"%2\" out."),
                        {link, text.settings.join(u',')});
    return std::vector{training(project)};
}

MakeLink RingLinkKind::planned(const Project &project, BusId bus) const
{
    const ProjectLink &link = ringPlan(project, bus).link;
    if (link.kind == ProjectLink().kind)
        return trainingRing(bus);
    return [name = findBus(project, bus)->name, link](const Catalog &) {
        return Checked<std::unique_ptr<BusAccess>>(
            badInput(QStringLiteral("noSuchLink"),
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
