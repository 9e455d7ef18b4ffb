// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/refusal.h"

#include <QStringList>

namespace codewheel {

// `pattern` with %1..%9 replaced by the parts, in one go, so that a part may hold a % itself. A part that is
// missing is shown as "?"; what would steer a terminal in one becomes an escape (encoder/shown_text.h).
QString sentence(const QString &pattern, const QStringList &parts);

// A whole number by locale.
QString numberText(std::int64_t number);

// Numbers by locale, words with eight hexadecimal digits, parameters by name.
QString argumentText(const RefusalArgument &argument);
QStringList argumentTexts(const std::vector<RefusalArgument> &arguments);

} // namespace codewheel
