// SPDX-License-Identifier: GPL-3.0-or-later
#include "vocabulary/serial_number_text.h"

namespace codewheel {

QString serialNumberText(std::int64_t number)
{
    return QStringLiteral("%1 (%2h)").arg(number).arg(QString::number(number, 16).toUpper());
}

} // namespace codewheel
