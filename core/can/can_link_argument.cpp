// SPDX-License-Identifier: GPL-3.0-or-later
#include "can/can_link_argument.h"

#include "can/can_refusals.h"
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

Result<void> takeCanSetting(CanLinkArgument &link, const QString &setting)
{
    constexpr int highestBaudRate = 12'000'000;
    const QString key = setting.section(u'=', 0, 0);
    const QString text = setting.section(u'=', 1);
    const int number = text.toInt();
    if (key == QStringLiteral("rate")) {
        if (!link.isSerial)
            return refuse(RefusalKind::badInput, CanRefusalId::rateBySystem, {link.where});
        if (std::ranges::find(slcanRates, number) == slcanRates.end())
            return refuse(RefusalKind::badInput, CanRefusalId::rateWrong, {text, slcanRatesText()});
        link.rate = number;
        return {};
    }
    if (key == QStringLiteral("baud") && link.isSerial) {
        if (number <= 0 || number > highestBaudRate)
            return refuse(RefusalKind::badInput, CanRefusalId::baudRateWrong, {text});
        link.baudRate = number;
        return {};
    }
    return refuse(RefusalKind::badInput,
                  link.isSerial ? CanRefusalId::settingUnknown : CanRefusalId::linkNotUnderstood, {setting});
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
