// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/words/device_number.h"

#include <charconv>

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

NodeId DeviceNumber::node() const
{
    return *this == DeviceNumber() ? NodeId() : NodeId(toString().toStdString());
}

DeviceNumber DeviceNumber::of(NodeId node)
{
    const std::string_view text = node.text();
    const std::size_t dot = text.find('.');
    if (dot == std::string_view::npos)
        return {};
    const auto number = [](std::string_view digits) {
        int value = 0;
        std::from_chars(digits.data(), digits.data() + digits.size(), value);
        return value;
    };
    return {number(text.substr(0, dot)), number(text.substr(dot + 1))};
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
