// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <cstdint>

namespace codewheel {

// "20417 (4FC1h)": labels have the one or the other. Without separators, to be compared with a label by eye
// and by search.
inline QString serialNumberText(std::int64_t number)
{
    return QStringLiteral("%1 (%2h)").arg(number).arg(QString::number(number, 16).toUpper());
}

} // namespace codewheel
