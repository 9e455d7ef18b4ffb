// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRectF>
#include <QString>

#include <vector>

class QWidget;

namespace codewheel::test {

// A piece of text as a widget paints it, in the widget's coordinates.
struct PaintedText
{
    QString text;
    QRectF ink;  // of its letters
    QRectF room; // outside of this they are not seen
};

// What a widget paints without its children, whatever kind of widget it is: it is painted on something that
// keeps the texts and draws nothing.
std::vector<PaintedText> paintedTexts(QWidget &widget);

} // namespace codewheel::test
