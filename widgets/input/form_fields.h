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

    // Takes what is typed. Where it is refused: the sentence, and nothing is taken.
    virtual QString takeTyped() = 0;
};

// Takes what stands in the fields of the form, for a button that is pressed while somebody types. The first
// that is refused gets the focus, and its sentence is returned; empty: all are good.
QString takeFields(const QWidget &form);

} // namespace codewheel
