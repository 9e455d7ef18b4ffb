// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace codewheel {

// An ID code or a device code as the manuals write it, with this many digits: "37h", "0237h".
inline QString hexCode(unsigned code, int digits)
{
    return QString::number(code, 16).toUpper().rightJustified(digits, u'0') + u'h';
}

} // namespace codewheel
