// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/protocol/canopen_address.h"

#include "vocabulary/hex.h"

#include <string>

namespace codewheel {

QString CanopenAddress::shown() const
{
    return QStringLiteral("%1 (%2)").arg(node).arg(hexNumber(static_cast<std::uint32_t>(node), 2));
}

std::optional<CanopenAddress> CanopenAddress::read(QStringView text)
{
    constexpr QLatin1String ofPlace(prefix.data(), qsizetype{prefix.size()});
    if (!text.startsWith(ofPlace))
        return std::nullopt;
    const QStringView digits = text.sliced(ofPlace.size());
    const CanopenAddress address{digits.toInt()};
    const bool isWritten = address.isNode() && QString::number(address.node) == digits;
    return isWritten ? std::optional(address) : std::nullopt;
}

} // namespace codewheel
