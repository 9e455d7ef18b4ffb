// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdf/cam_picture_layout.h"

#include "pdf/sheet_format.h"
#include "report/cam_bars.h"

#include <algorithm>

namespace codewheel {
namespace {

using sheet::mm;

constexpr qreal rowHeight = mm(3.6);
constexpr qreal barHeight = mm(2);
constexpr qreal pictureLeft =
    sheet::body.left() + mm(5); // of the bars; before them stands the number of the cam
constexpr qreal pictureWidth = sheet::body.right() - pictureLeft;
constexpr qreal bottom = rowHeight * CamProgram::cams;

void addRows(SheetFlow &flow, const CamPicture &picture)
{
    const QFont &font = flow.fonts().small;
    for (const CamBar &bar : camBars(picture)) {
        const qreal top = flow.y() + rowHeight * static_cast<qreal>(bar.cam) + (rowHeight - barHeight) / 2;
        flow.sheet().bars.push_back(
            {{pictureLeft + pictureWidth * bar.begin, top,
              std::max(sheet::thickLine, pictureWidth * (bar.end - bar.begin)), barHeight},
             bar.active});
    }
    for (std::size_t cam = 0; cam < CamProgram::cams; ++cam) {
        const qreal above = (rowHeight - lineHeight(font)) / 2;
        flow.skip(above);
        flow.addText(QString::number(cam), font, sheet::body.left(), pictureLeft - sheet::body.left());
        flow.skip(rowHeight - above);
        flow.sheet().lines.push_back(
            {{pictureLeft, flow.y(), pictureLeft + pictureWidth, flow.y()}, sheet::thinLine, true});
    }
}

} // namespace

void addCamPicture(SheetFlow &flow, const CamPicture &picture)
{
    const ReportFonts &fonts = flow.fonts();
    const qreal textHeight = lineHeight(fonts.small);
    const auto titleLines =
        static_cast<qreal>(textLines(picture.title, fonts.text, sheet::body.width()).size());
    flow.need(titleLines * lineHeight(fonts.text) + bottom + textHeight + sheet::gap);
    flow.addParagraph(picture.title, fonts.text, sheet::body.left(), sheet::body.width());
    flow.skip(mm(0.8));
    addRows(flow, picture);
    const qreal half = pictureWidth / 2;
    flow.addText(picture.firstText, fonts.small, pictureLeft, half);
    flow.addText(picture.lastText, fonts.small, pictureLeft + half, half, SheetFlow::Align::right);
    flow.skip(textHeight + sheet::gap);
}

} // namespace codewheel
