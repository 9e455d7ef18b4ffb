// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <map>

class QWidget;

namespace codewheel {

// What is being typed in the fields of a window, by where each is in it: for the same window in another
// language.
using TypedTexts = std::map<QString, QString>;
TypedTexts typedTexts(const QWidget &window);
void typeAgain(QWidget &window, const TypedTexts &texts);

} // namespace codewheel
