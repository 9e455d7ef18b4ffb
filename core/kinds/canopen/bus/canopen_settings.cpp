// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/bus/canopen_settings.h"

namespace codewheel {
namespace {

QString rateText(int rate)
{
    return QStringLiteral(",%1=%2").arg(QLatin1String(canRateKey)).arg(rate);
}

} // namespace

CanopenSettings canopenSettings(const CanLinkArgument &link, int rate)
{
    return {.link = link.text().remove(rateText(link.rate)), .rate = link.rate != 0 ? link.rate : rate};
}

Result<CanLinkArgument> canLinkOf(const CanopenSettings &settings)
{
    const auto asInterface = parseCanLink(settings.link);
    return asInterface ? asInterface : parseCanLink(settings.link + rateText(settings.rate));
}

} // namespace codewheel
