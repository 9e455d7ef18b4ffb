// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

// What a control is called, and what it says of itself: `id` is for tests and kept layouts, `name` for screen
// readers, and `tip` for both readers and those who point at it, since a tooltip is read where there is no
// other description. All give back the control.
namespace codewheel {

// One that says nothing of itself.
template <class Control>
Control *named(Control *control, const char *id)
{
    control->setObjectName(QLatin1String(id));
    return control;
}

// One that shows no text of its own.
template <class Control>
Control *describe(Control *control, const QString &name, const QString &tip)
{
    control->setAccessibleName(name);
    control->setToolTip(tip);
    return control;
}

// One whose own text is its name.
template <class Control>
Control *describe(Control *control, const char *id, const QString &tip)
{
    control->setToolTip(tip);
    return named(control, id);
}

template <class Control>
Control *describe(Control *control, const char *id, const QString &name, const QString &tip)
{
    return describe(named(control, id), name, tip);
}

} // namespace codewheel
