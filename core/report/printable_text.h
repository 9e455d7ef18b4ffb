// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace codewheel {

// A text that somebody typed, or that was in a file, made printable: what XML must not contain (control
// characters, halves of surrogate pairs) and what would change the direction of the text around it
// (bidirectional overrides) become U+FFFD. Line breaks stay.
QString printableText(const QString &text);

} // namespace codewheel
