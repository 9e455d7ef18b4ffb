// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace codewheel {

// A text that somebody typed, or that stood in a file, as it may be printed: what no XML file may hold
// (control characters, halves of surrogate pairs) and what would turn the text around it (bidirectional
// overrides) become U+FFFD. Line breaks stay.
QString printableText(const QString &text);

} // namespace codewheel
