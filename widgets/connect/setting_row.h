// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/layouts.h"

class QFormLayout;
class QLabel;
class QString;

namespace codewheel {

// What a setting means, in small type below its field.
QLabel *settingSentence(const QString &sentence, QWidget *parent);

// A setting in the form of a link: its field, and below it what it means. Returns the label of the sentence.
// `buddy`: what the key of the label goes to, the field or a part of it.
QLabel *addSettingRow(QFormLayout &form, const QString &label, LayoutPart field, QWidget *buddy,
                      const QString &sentence);

} // namespace codewheel
