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

const QString linePrefix = QStringLiteral("esc:");

std::optional<DeviceNumber> parseOnLine(QStringView text)
{
    if (text.startsWith(linePrefix))
        text = text.sliced(linePrefix.size());
    const auto address = text.size() == 2 ? LineAddress::fromWire(text) : std::nullopt;
    if (!address)
        return std::nullopt;
    return DeviceNumber::onLine(*address);
}

} // namespace

QString DeviceNumber::toString() const
{
    if (isOnLine())
        return linePrefix + line.onWire();
    return QStringLiteral("%1.%2").arg(segment).arg(position);
}

std::optional<DeviceNumber> DeviceNumber::parse(QStringView text)
{
    const qsizetype dot = text.indexOf(u'.');
    if (dot < 0)
        return parseOnLine(text);
    const auto segment = wholeNumber(text.first(dot));
    const auto position = wholeNumber(text.sliced(dot + 1));
    if (!segment || !position || *segment == 0)
        return std::nullopt;
    return DeviceNumber{*segment, *position};
}

} // namespace codewheel
