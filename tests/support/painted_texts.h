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
    QRectF ink;  // of its characters
    QRectF room; // beyond which they are not visible
};

// What a widget, whatever its kind, paints without its children: it is painted on a device that records the
// texts and draws nothing.
std::vector<PaintedText> paintedTexts(QWidget &widget);

} // namespace codewheel::test
