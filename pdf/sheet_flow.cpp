// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdf/sheet_flow.h"

#include "pdf/sheet_format.h"

#include <QFontMetricsF>

namespace codewheel {

SheetFlow::SheetFlow()
    : m_sheets(1)
    , m_y(sheet::body.top())
{}

qreal SheetFlow::room() const
{
    return sheet::body.bottom() - m_y;
}

bool SheetFlow::isAtTop() const
{
    return m_y <= sheet::body.top();
}

void SheetFlow::nextSheet()
{
    m_sheets.emplace_back();
    m_y = sheet::body.top();
}

void SheetFlow::need(qreal height)
{
    if (height > room() && !isAtTop())
        nextSheet();
}

void SheetFlow::addText(const QString &line, const QFont &font, qreal left, qreal width, Align align)
{
    placeText(sheet(), line, font, {left, m_y, width, lineHeight(font)}, align);
}

void SheetFlow::addThickRule()
{
    sheet().lines.push_back({{sheet::body.left(), m_y, sheet::body.right(), m_y}, sheet::thickLine});
}

void SheetFlow::addFaintRule()
{
    sheet().lines.push_back({{sheet::body.left(), m_y, sheet::body.right(), m_y}, sheet::thinLine, true});
}

void SheetFlow::addParagraph(const QString &text, const QFont &font, qreal left, qreal width)
{
    for (const QString &line : textLines(text, font, width)) {
        need(lineHeight(font));
        addText(line, font, left, width);
        skip(lineHeight(font));
    }
}

void placeText(Sheet &sheet, const QString &line, const QFont &font, const QRectF &room,
               SheetFlow::Align align)
{
    if (line.isEmpty())
        return;
    const qreal width = textWidth(line, font);
    const qreal left = align == SheetFlow::Align::left ? room.left() : room.right() - width;
    sheet.texts.push_back(
        {{left, room.top(), width, room.height()}, room.top() + QFontMetricsF(font).ascent(), line, font});
}

} // namespace codewheel
