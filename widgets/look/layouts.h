// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QBoxLayout>
#include <QMargins>

#include <initializer_list>
#include <optional>

class QFormLayout;

namespace codewheel {

struct Stretch
{
    int factor = 0;
};

// A part of a row or column: a widget, a row or column of its own, or free space.
struct LayoutPart
{
    LayoutPart(QWidget *part, int stretch = 0, Qt::Alignment where = {})
        : widget(part)
        , factor(stretch)
        , alignment(where)
    {}
    LayoutPart(QLayout *part, int stretch = 0)
        : layout(part)
        , factor(stretch)
    {}
    LayoutPart(Stretch stretch)
        : factor(stretch.factor)
    {}

    QWidget *widget = nullptr;
    QLayout *layout = nullptr; // neither: free space
    int factor = 0;
    Qt::Alignment alignment{};
};

struct LayoutRoom
{
    std::optional<int> spacing{}; // between the parts; unset: the style's
    std::optional<QMargins> margins{};
};

inline QMargins allAround(int margin)
{
    return {margin, margin, margin, margin};
}

// The parts side by side, or one below the other; in a widget, or to be put into another layout.
using LayoutParts = std::initializer_list<LayoutPart>;
QBoxLayout *layOutRow(LayoutParts parts, const LayoutRoom &room = {});
QBoxLayout *layOutColumn(LayoutParts parts, const LayoutRoom &room = {});
void layOutRow(QWidget *of, LayoutParts parts, const LayoutRoom &room = {});
void layOutColumn(QWidget *of, LayoutParts parts, const LayoutRoom &room = {});

// A form, `between` its rows; in a widget, or (null) to be put into another layout.
QFormLayout *makeForm(QWidget *of, int between, int marginOnAllSides = 0);

// A row or column in a widget whose parts are added one by one, by default without margins.
template <class Box>
Box *layOut(QWidget *widget, int spacing, const QMargins &margins = {})
{
    auto *box = new Box(widget);
    box->setSpacing(spacing);
    box->setContentsMargins(margins);
    return box;
}
template <class Box>
Box *layOut(QWidget *widget, int spacing, int marginOnAllSides)
{
    return layOut<Box>(widget, spacing, allAround(marginOnAllSides));
}

} // namespace codewheel
