// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/kinds/canopen/canopen_link.h"

#include "cli/call/texts.h"
#include "vocabulary/sentence.h"

#include <array>

namespace codewheel {
namespace {

const QString canopenScheme = QStringLiteral("canopen");
const QString slcanScheme = QStringLiteral("slcan");
const QString simulatedCanBus = QStringLiteral("training");
const QString agreement = QStringLiteral("yes");

struct Agreement
{
    const char *key;
    bool CanopenLink::*what;
};
constexpr std::array agreements{Agreement{unsureWatchKey, &CanopenLink::takesUnsureWatch},
                                Agreement{besideMasterKey, &CanopenLink::sendsBesideOthers},
                                Agreement{mayStopKey, &CanopenLink::mayStopNodes}};

// Takes them out of the settings.
Checked<void> takeAgreements(CanopenLink &link, LinkText &text)
{
    for (const Agreement &one : agreements) {
        const QString key = QString::fromLatin1(one.key);
        const auto given = text.take(key);
        if (given && *given != agreement)
            return badInput("canAgreementWrong",
                            CommandLine::tr("%1 cannot be \"%2\": write %1=yes, or leave it out."),
                            {key, *given});
        link.*one.what = given.has_value();
    }
    return {};
}

Checked<CanopenLink> linkAt(CanopenLink link, const LinkText &text)
{
    const QString typed = QStringList{QStringList{text.link()} + text.settings}.join(u',');
    const auto at = parseCanLink(typed);
    if (!at)
        return tl::unexpected(complaintAbout(at.error()));
    link.at = *at;
    link.settings = canopenSettings(*at, link.settings.rate);
    return link;
}

Checked<CanopenLink> simulatedLink(CanopenLink link, const LinkText &text)
{
    if (text.where != simulatedCanBus)
        return unknownLink(text.link());
    if (text.settings.isEmpty())
        return link;
    return badInput("unknownCanSetting",
                    CommandLine::tr("The simulated CAN bus has no setting \"%1\". Its settings are: %2."),
                    {text.settings.front(), canopenSettingKeys(canopenScheme).join(QStringLiteral(", "))});
}

Complaint noCanLink(const QString &bus)
{
    return notDone(
        "noCanLinkInProject",
        sentence(CommandLine::tr("The link that the project has for \"%1\" cannot be used. Name it, as "
                                 "--link can:can0."),
                 {bus}),
        {bus});
}

} // namespace

QStringList canopenSettingKeys(const QString &scheme)
{
    QStringList keys;
    if (scheme == slcanScheme)
        for (const CanSetting &one : canSettings())
            keys << QString::fromLatin1(one.key);
    for (const Agreement &one : agreements)
        keys << QString::fromLatin1(one.key);
    return keys;
}

Checked<CanopenLink> canopenLinkMeant(const LinkText &text)
{
    CanopenLink link;
    LinkText rest = text;
    if (const auto taken = takeAgreements(link, rest); !taken)
        return tl::unexpected(taken.error());
    return rest.scheme == canopenScheme ? simulatedLink(link, rest) : linkAt(link, rest);
}

Checked<CanopenLink> canopenLinkOf(const Project &project, BusId bus, const QStringList &settings)
{
    CanopenLink link{.settings = canopenPlan(project, bus)->settings};
    const auto planned = LinkText::parse(link.settings.link);
    LinkText text = planned.value_or(LinkText{canopenScheme, simulatedCanBus, {}});
    text.settings += settings;
    if (const auto taken = takeAgreements(link, text); !taken)
        return tl::unexpected(taken.error());
    if (link.isSimulated())
        return simulatedLink(link, text);
    if (text.scheme == slcanScheme)
        text.settings.prepend(QStringLiteral("%1=%2").arg(QLatin1String(canRateKey)).arg(link.settings.rate));
    if (planned)
        if (auto there = linkAt(link, text); there || !settings.isEmpty())
            return there;
    link.whyNot = noCanLink(findBus(project, bus)->name);
    return link;
}

} // namespace codewheel
