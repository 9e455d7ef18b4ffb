// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/layouts.h"

#include "widgets/look/grid.h"

#include <QFormLayout>
#include <QWidget>

namespace codewheel {
namespace {

QBoxLayout *layOut(QBoxLayout *layout, LayoutParts parts, const LayoutRoom &room)
{
    if (room.spacing)
        layout->setSpacing(*room.spacing);
    if (room.margins)
        layout->setContentsMargins(*room.margins);
    for (const LayoutPart &part : parts)
        if (part.widget)
            layout->addWidget(part.widget, part.factor, part.alignment);
        else if (part.layout)
            layout->addLayout(part.layout, part.factor);
        else
            layout->addStretch(part.factor);
    return layout;
}

} // namespace

QBoxLayout *layOutRow(LayoutParts parts, const LayoutRoom &room)
{
    return layOut(new QHBoxLayout, parts, room);
}

QBoxLayout *layOutColumn(LayoutParts parts, const LayoutRoom &room)
{
    return layOut(new QVBoxLayout, parts, room);
}

void layOutRow(QWidget *of, LayoutParts parts, const LayoutRoom &room)
{
    layOut(new QHBoxLayout(of), parts, room);
}

void layOutColumn(QWidget *of, LayoutParts parts, const LayoutRoom &room)
{
    layOut(new QVBoxLayout(of), parts, room);
}

QFormLayout *makeForm(QWidget *of, int between, int marginOnAllSides)
{
    auto *form = new QFormLayout(of);
    form->setContentsMargins(allAround(marginOnAllSides));
    form->setHorizontalSpacing(grid::groupGap);
    form->setVerticalSpacing(between);
    return form;
}

} // namespace codewheel
