// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFont>
#include <QLineF>
#include <QRectF>
#include <QString>

#include <vector>

namespace codewheel {

// One sheet of paper with everything on it, in dots from its top left corner (sheet_format.h).
struct Sheet
{
    struct Text // of one line
    {
        QRectF box;
        qreal baseLine = 0;
        QString text;
        QFont font;
    };
    struct Line
    {
        QLineF line;
        qreal width = 0;
        bool faint = false; // grey
    };
    struct Bar // outlined, or filled
    {
        QRectF box;
        bool filled = false;
    };

    std::vector<Text> texts;
    std::vector<Line> lines;
    std::vector<Bar> bars;
};

} // namespace codewheel
