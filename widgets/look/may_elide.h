// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractItemView>
#include <QVariant>

// Which texts may be cut short where they have no room, and end with three dots. No other may, and a test
// looks for it in all languages and sizes. For texts that can be as long as they like, whose whole stands in
// a tooltip and is told to screen readers.
namespace codewheel {

inline constexpr const char *mayElideProperty = "mayElide"; // true, or the columns

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
