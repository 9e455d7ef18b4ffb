// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace codewheel {

// A text cell of a table of comma-separated values (RFC 4180), in quotation marks. Text that a spreadsheet
// would take for a formula, because it begins with = + - @, a tab or a carriage return, gets an apostrophe in
// front. Numbers and dates are not text: they are written as they are.
QString csvText(QString text);

} // namespace codewheel
