// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace codewheel {

// A cell with text in a table of comma-separated values (RFC 4180), in quotation marks. A text that a
// spreadsheet would take for a formula, since it begins with = + - @, a tab or a carriage return, gets an
// apostrophe before it. Numbers and dates are no text: they are written as they are.
QString csvText(QString text);

} // namespace codewheel
