// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/kinds/link_kind.h"

#include "catalog/device_description.h"
#include "cli/call/texts.h"
#include "cli/kinds/canopen/canopen_link_kind.h"
#include "cli/kinds/esc/esc_line_link_kind.h"
#include "cli/kinds/interbus/ring_link_kind.h"
#include "project/bus_kind.h"
#include "project/bus_plans.h"
#include "vocabulary/sentence.h"

#include <algorithm>

namespace codewheel {
namespace {

const QString trainingLink = QStringLiteral("training");
const QString projectLink = QStringLiteral("project");
const QString protocolSetting = QStringLiteral("protocol");

// The list of kinds.
std::vector<std::unique_ptr<const LinkKind>> kindsOfTheProgram()
{
    std::vector<std::unique_ptr<const LinkKind>> kinds;
    kinds.push_back(ringLinkKind());
    kinds.push_back(gatewayLinkKind());
    kinds.push_back(lineLinkKind());
    kinds.push_back(canopenLinkKind());
    kinds.push_back(canLogLinkKind());
    return kinds;
}

std::vector<std::unique_ptr<const LinkKind>> &kinds()
{
    static auto all = kindsOfTheProgram();
    return all;
}

QString linksThereAre()
{
    QStringList ofOneKind;
    QStringList texts{CommandLine::tr("training, the simulated buses"),
                      CommandLine::tr("project, all buses of the project")};
    for (const LinkKind *kind : linkKinds()) {
        for (const QString &scheme : kind->leadsToPlanned() ? kind->schemes() : QStringList())
            ofOneKind << LinkText{scheme, projectLink, {}}.link();
        if (const QString help = kind->help(); !help.isEmpty())
            texts << help;
    }
    ofOneKind.removeDuplicates();
    texts.insert(
        2, sentence(CommandLine::tr("%1, those of one kind alone"), {ofOneKind.join(QStringLiteral(", "))}));
    return texts.join(QStringLiteral("; "));
}

Checked<const LinkKind *> kindMeant(LinkText &text, const QString &typed)
{
    std::vector<const LinkKind *> those;
    for (const LinkKind *kind : linkKinds())
        if (kind->schemes().contains(text.scheme))
            those.push_back(kind);
    if (those.empty())
        return unknownLink(typed);
    const auto protocol = text.take(protocolSetting);
    if (those.size() == 1 && !protocol)
        return those.front();
    const auto found = std::ranges::find(those, protocol.value_or(QString()), &LinkKind::bus);
    if (found != those.end())
        return *found;
    const QString where = text.link();
    if (!protocol)
        return badInput("protocolMissing",
                        CommandLine::tr("Say with protocol= what is spoken at %1. There is: %2."),
                        {where, listed(those, &LinkKind::bus)});
    return badInput("unknownProtocol",
                    CommandLine::tr("\"%1\" is not spoken at %2. What protocol= can name there: %3."),
                    {*protocol, where, listed(those, &LinkKind::bus)});
}

// The last one would silently win.
Checked<void> checkEachOnce(const QStringList &settings)
{
    QStringList keys;
    for (const QString &setting : settings) {
        const QString key = setting.section(u'=', 0, 0);
        if (!key.isEmpty() && keys.contains(key))
            return badInput("linkSettingGivenTwice", CommandLine::tr("%1 is given twice. Give it once."),
                            {key});
        keys << key;
    }
    return {};
}

std::vector<MakeLink> trainingLinks(const Project *project)
{
    std::vector<MakeLink> links;
    for (const LinkKind *kind : linkKinds())
        if (MakeLink link = kind->training(project))
            links.push_back(std::move(link));
    return links;
}

// For these kinds. `link`: as typed.
Checked<std::vector<MakeLink>> plannedLinks(const std::vector<const LinkKind *> &those, const QString &link,
                                            const QStringList &settings, const Project *project)
{
    if (project == nullptr)
        return badInput("noProject",
                        CommandLine::tr("The link \"%1\" needs a project. Name it with --project FILE."),
                        {link});
    std::vector<MakeLink> links;
    for (const PlannedBus &bus : project->buses) {
        const auto kind = std::ranges::find(those, bus.kind, &LinkKind::bus);
        if (kind == those.end())
            continue;
        auto planned = (*kind)->planned(*project, bus.id, settings);
        if (!planned)
            return tl::unexpected(planned.error());
        links.push_back(*std::move(planned));
    }
    if (links.empty())
        return badInput("noBuses", CommandLine::tr("The project has no buses for the link \"%1\"."), {link});
    return links;
}

} // namespace

std::optional<LinkText> LinkText::parse(const QString &typed)
{
    const qsizetype colon = typed.indexOf(u':');
    if (colon <= 0)
        return std::nullopt;
    QStringList parts = typed.sliced(colon + 1).split(u',');
    const QString where = parts.takeFirst();
    return LinkText{typed.first(colon), where, parts};
}

std::optional<QString> LinkText::take(const QString &setting)
{
    const auto found = std::ranges::find_if(
        settings, [&](const QString &one) { return one.section(u'=', 0, 0) == setting; });
    if (found == settings.end())
        return std::nullopt;
    const QString value = found->section(u'=', 1);
    settings.erase(found);
    return value;
}

Checked<DeviceDescription> LinkKind::asOnLink(const Call &, DeviceDescription device) const
{
    return device;
}

std::vector<const LinkKind *> linkKinds()
{
    std::vector<const LinkKind *> all;
    for (const auto &kind : kinds())
        all.push_back(kind.get());
    return all;
}

std::vector<Service> allServices()
{
    std::vector<Service> services;
    for (const LinkKind *kind : linkKinds())
        services.insert(services.end(), kind->services().begin(), kind->services().end());
    return services;
}

std::shared_ptr<const LinkKind> addLinkKind(std::unique_ptr<const LinkKind> kind)
{
    const LinkKind *added = kind.get();
    kinds().push_back(std::move(kind));
    return {added, [](const LinkKind *ended) {
                std::erase_if(kinds(), [ended](const auto &one) { return one.get() == ended; });
            }};
}

BusId numberOf(const LinkKind &kind, const Project *project, std::optional<BusId> meant)
{
    const BusKind &its = *busKind(kind.bus());
    const BusId training = its.trainingBus().value_or(BusId{});
    if (project == nullptr || meant)
        return meant.value_or(training);
    std::vector<BusId> planned;
    for (const PlannedBus &bus : project->buses)
        if (bus.kind == kind.bus())
            planned.push_back(bus.id);
    if (planned.size() == 1)
        return planned.front();
    return std::ranges::count(planned, training) > 0 ? training : freeNumber(*project, its);
}

Checked<std::vector<MakeLink>> linksMeant(const QString &typed, const Project *project)
{
    if (typed == trainingLink)
        return trainingLinks(project);
    if (typed == projectLink)
        return plannedLinks(linkKinds(), typed, {}, project);
    auto text = LinkText::parse(typed);
    if (!text)
        return unknownLink(typed);
    return checkEachOnce(text->settings)
        .and_then([&] { return kindMeant(*text, typed); })
        .and_then([&](const LinkKind *kind) {
            return text->where == projectLink && kind->leadsToPlanned()
                       ? plannedLinks({kind}, text->link(), text->settings, project)
                       : kind->links(*text, project);
        });
}

tl::unexpected<Complaint> unknownLink(const QString &typed)
{
    return badInput("unknownLink", CommandLine::tr("There is no link \"%1\". The links are: %2."),
                    {typed, linksThereAre()});
}

} // namespace codewheel
