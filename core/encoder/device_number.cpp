// SPDX-License-Identifier: GPL-3.0-or-later
#include "encoder/device_number.h"

namespace codewheel {
namespace {

// Plain digits only: toInt() alone would also take "+1" and " 1".
std::optional<int> wholeNumber(QStringView text)
{
    if (text.isEmpty() || text.size() > 3)
        return std::nullopt;
    for (const QChar c : text)
        if (c < u'0' || c > u'9')
            return std::nullopt;
    return text.toInt();
}

} // namespace

QString DeviceNumber::toString() const
{
    return QStringLiteral("%1.%2").arg(segment).arg(position);
}

std::optional<DeviceNumber> DeviceNumber::parse(QStringView text)
{
    const qsizetype dot = text.indexOf(u'.');
    if (dot < 0)
        return std::nullopt;
    const auto segment = wholeNumber(text.first(dot));
    const auto position = wholeNumber(text.sliced(dot + 1));
    if (!segment || !position || *segment == 0)
        return std::nullopt;
    return DeviceNumber{*segment, *position};
}

} // namespace codewheel
