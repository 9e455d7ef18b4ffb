// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QWidget;

namespace codewheel {

// What a form asks of its fields before it uses their values.
class FormField
{
public:
    virtual ~FormField() = default;

    // Takes what is typed. If refused: the sentence, and nothing is taken.
    virtual QString takeTyped() = 0;
};

// Takes the input of all fields of the form, for a button pressed while somebody is typing. The first refused
// field gets the focus, and its sentence is returned; empty: all are good.
QString takeFields(const QWidget &form);

} // namespace codewheel
