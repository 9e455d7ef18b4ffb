// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

// What a control is called and how it describes itself: `id` is for tests and saved layouts, `name` for
// screen readers, and `tip` for both the mouse and screen readers, which read a tooltip where there is no
// other description. All return the control.
namespace codewheel {

// A control without a description.
template <class Control>
Control *named(Control *control, const char *id)
{
    control->setObjectName(QLatin1String(id));
    return control;
}

// A control that shows no text of its own.
template <class Control>
Control *describe(Control *control, const QString &name, const QString &tip)
{
    control->setAccessibleName(name);
    control->setToolTip(tip);
    return control;
}

// A control named by its own text.
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

// Words of the field by which the command palette finds an action, too, in each language.
inline constexpr const char *alsoFoundBy = "alsoFoundBy";
template <class Action>
Action *foundBy(Action *action, const QString &words)
{
    action->setProperty(alsoFoundBy, words);
    return action;
}

} // namespace codewheel
