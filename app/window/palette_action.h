// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QAction;

namespace codewheel {

class OtherLanguage;

// What an action does, or why it cannot be done now; empty: its text says it.
QString tipOf(const QAction &action);
// By which it is found besides its text and its tip: both in the other language, and what people of the field
// call it, in both.
QString wordsOf(const QAction &action, OtherLanguage &otherLanguage);

} // namespace codewheel
