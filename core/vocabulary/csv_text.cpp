// SPDX-License-Identifier: GPL-3.0-or-later
#include "vocabulary/csv_text.h"

namespace codewheel {

QString csvText(QString text)
{
    if (!text.isEmpty() && QStringLiteral("=+-@\t\r").contains(text[0]))
        text.prepend(u'\'');
    text.replace(u'"', QStringLiteral("\"\""));
    return u'"' + text + u'"';
}

} // namespace codewheel
