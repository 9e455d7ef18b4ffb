// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/refusal.h"

#include <QStringList>

namespace codewheel {

// `pattern` with %1..%9 replaced by the parts, in one go, so that a part may contain a % itself. A missing
// part is shown as "?"; characters in a part that would control a terminal are escaped
// (vocabulary/shown_text.h).
QString sentence(const QString &pattern, const QStringList &parts);

// A whole number by locale.
QString numberText(std::int64_t number);
// A value of which no description says how it is shown: a number by locale, or a text.
QString plainText(const Value &value);

// Numbers by locale, words with eight hexadecimal digits, parameters by name.
QString argumentText(const RefusalArgument &argument);
QStringList argumentTexts(const std::vector<RefusalArgument> &arguments);

} // namespace codewheel
