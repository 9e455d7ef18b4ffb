// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/cam_bars.h"
#include "report/html_report.h"
#include "report/printable_text.h"

namespace codewheel {
namespace {

// In units of the picture.
constexpr double svgWidth = 680;
constexpr double barsLeft = 20; // of the bars; the number of the cam is before them
constexpr double right = 676;
constexpr double rowHeight = 14;
constexpr double barHeight = 8;
constexpr double textRise = 4; // of a base line above the bottom of its row

QString svgNumber(double value)
{
    return QString::number(value, 'f', 1);
}

QString line(double x1, double y1, double x2, double y2)
{
    return QStringLiteral("<line x1=\"%1\" y1=\"%2\" x2=\"%3\" y2=\"%4\" stroke=\"gray\" "
                          "stroke-width=\"0.5\"/>\n")
        .arg(svgNumber(x1), svgNumber(y1), svgNumber(x2), svgNumber(y2));
}

QString textAt(double x, double y, const QString &anchor, const QString &text)
{
    return QStringLiteral("<text x=\"%1\" y=\"%2\" text-anchor=\"%3\">")
               .arg(svgNumber(x), svgNumber(y), anchor) +
           printableText(text).toHtmlEscaped() + QStringLiteral("</text>\n");
}

QString barSvg(const CamBar &bar)
{
    const double scale = right - barsLeft;
    const double top = rowHeight * static_cast<double>(bar.cam) + (rowHeight - barHeight) / 2;
    const double shownWidth = std::max(1.0, scale * (bar.end - bar.begin)); // even for a single position
    return QStringLiteral(
               "<rect x=\"%1\" y=\"%2\" width=\"%3\" height=\"%4\" fill=\"%5\" stroke=\"black\"/>\n")
        .arg(svgNumber(barsLeft + scale * bar.begin), svgNumber(top), svgNumber(shownWidth),
             svgNumber(barHeight), bar.active ? QStringLiteral("black") : QStringLiteral("white"));
}

} // namespace

QString camPictureAsSvg(const CamPicture &picture)
{
    const double height = rowHeight * static_cast<double>(picture.cams + 1);
    QString svg = QStringLiteral("<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" "
                                 "font-family=\"sans-serif\" font-size=\"9\" viewBox=\"0 0 %1 %2\" "
                                 "aria-label=\"")
                      .arg(svgNumber(svgWidth), svgNumber(height)) +
                  printableText(picture.title).toHtmlEscaped() + QStringLiteral("\">\n");
    for (std::size_t cam = 0; cam < picture.cams; ++cam) {
        const double foot = rowHeight * static_cast<double>(cam + 1);
        svg += textAt(0, foot - textRise, QStringLiteral("start"), QString::number(cam));
        svg += line(barsLeft, foot, right, foot);
    }
    for (const CamBar &bar : camBars(picture))
        svg += barSvg(bar);
    svg += textAt(barsLeft, height - textRise, QStringLiteral("start"), picture.firstText);
    svg += textAt(right, height - textRise, QStringLiteral("end"), picture.lastText);
    return svg + QStringLiteral("</svg>\n");
}

} // namespace codewheel
