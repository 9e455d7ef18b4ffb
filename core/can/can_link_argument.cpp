// SPDX-License-Identifier: GPL-3.0-or-later
#include "can/can_link_argument.h"

#include "can/can_refusals.h"
#include "can/can_settings.h"
#include "can/slcan_codec.h"

#include <QStringList>

#include <algorithm>

namespace codewheel {
namespace {

const QString socketCanScheme = QStringLiteral("can:");
const QString slcanScheme = QStringLiteral("slcan:");

// As long as the system allows (IFNAMSIZ).
bool isInterfaceName(const QString &name)
{
    constexpr qsizetype longest = 15;
    return !name.isEmpty() && name.size() <= longest && name != u'.' && name != QStringLiteral("..") &&
           std::ranges::none_of(name, [](QChar c) { return c == u'/' || c == u':' || c.isSpace(); });
}

// The rate of an interface is the system's.
Result<void> takeCanSetting(CanLinkArgument &link, const QString &setting)
{
    const QString key = setting.section(u'=', 0, 0);
    const QString text = setting.section(u'=', 1);
    const CanSetting *its = canSetting(key);
    if (!link.isSerial)
        return its != nullptr && its->its == &CanLinkArgument::rate
                   ? refuse(RefusalKind::badInput, CanRefusalId::rateBySystem, {link.where})
                   : refuse(RefusalKind::badInput, CanRefusalId::linkNotUnderstood, {setting});
    if (its == nullptr)
        return refuse(RefusalKind::badInput, CanRefusalId::settingUnknown, {setting});
    const int number = text.toInt();
    if (!its->hasAdapter(number)) {
        std::vector<RefusalArgument> about{text};
        if (!its->ofAdapters.empty())
            about.emplace_back(slcanRatesText());
        return refuse(RefusalKind::badInput, its->wrong, std::move(about));
    }
    link.*its->its = number;
    return {};
}

} // namespace

QString CanLinkArgument::text() const
{
    if (!isSerial)
        return socketCanScheme + where;
    const QString base = QStringLiteral("%1%2,rate=%3").arg(slcanScheme, where).arg(rate);
    return baudRate == usualBaudRate ? base : base + QStringLiteral(",baud=%1").arg(baudRate);
}

Result<CanLinkArgument> parseCanLink(const QString &typed)
{
    CanLinkArgument link{.isSerial = typed.startsWith(slcanScheme)};
    const QStringList parts = typed.section(u':', 1).split(u',');
    link.where = parts.front();
    const bool isUnderstood = link.isSerial
                                  ? !link.where.isEmpty()
                                  : typed.startsWith(socketCanScheme) && isInterfaceName(link.where);
    if (!isUnderstood)
        return refuse(RefusalKind::badInput, CanRefusalId::linkNotUnderstood, {typed});
    for (const QString &setting : parts.mid(1))
        if (const auto taken = takeCanSetting(link, setting); !taken)
            return tl::unexpected(taken.error());
    if (link.isSerial && link.rate == 0)
        return refuse(RefusalKind::badInput, CanRefusalId::rateMissing, {typed});
    return link;
}

QString slcanRatesText()
{
    QStringList texts;
    for (const int rate : slcanRates)
        texts << QString::number(rate);
    return texts.join(QStringLiteral(", "));
}

} // namespace codewheel
