// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/report/report_pages.h"

#include <QRectF>

namespace codewheel::test {

struct PaintedText
{
    QRectF box;
    QString text;
    bool isCut = false; // at the border of the paintable area
};

// The readable texts on a sheet, in pieces of lines.
std::vector<PaintedText> paintedTexts(const ReportPages &pages, int page);

} // namespace codewheel::test
