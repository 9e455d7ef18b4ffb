// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractItemView>
#include <QVariant>

// Marks texts that may be elided where they lack room. No other text may, and a test checks that in all
// languages and sizes. For texts of any length that are given in full in a tooltip and to screen readers.
namespace codewheel {

inline constexpr const char *mayElideProperty = "mayElide"; // true, or the list of columns

inline void allowEliding(QWidget &widget)
{
    widget.setProperty(mayElideProperty, true);
}

// In this column alone.
inline void allowEliding(QAbstractItemView &view, int column)
{
    view.setProperty(mayElideProperty, view.property(mayElideProperty).toList() << column);
}

inline bool mayElide(const QWidget &widget)
{
    return widget.property(mayElideProperty).typeId() == QMetaType::Bool;
}

inline bool mayElide(const QAbstractItemView &view, int column)
{
    return mayElide(static_cast<const QWidget &>(view)) ||
           view.property(mayElideProperty).toList().contains(column);
}

} // namespace codewheel
