// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdf/sheet.h"
#include "pdf/text_lines.h"

namespace codewheel {

// Fills sheets from top to bottom; who lays something out asks it for room first.
class SheetFlow
{
public:
    enum class Align { left, right };

    SheetFlow();

    const ReportFonts &fonts() const { return m_fonts; }
    Sheet &sheet() { return m_sheets.back(); }
    qreal y() const { return m_y; }
    qreal room() const; // below y
    bool isAtTop() const;

    void nextSheet();
    // Goes on to the next sheet where less than this is left. What is higher than a sheet begins on a new
    // one.
    void need(qreal height);
    void skip(qreal height) { m_y += height; }

    // One line at y, within left and width of the sheet; y stays.
    void addText(const QString &line, const QFont &font, qreal left, qreal width, Align align = Align::left);
    // A rule across the body, at y: thick, or thin and faint.
    void addThickRule();
    void addFaintRule();
    // The lines one below the other, going on to the next sheet as they need.
    void addParagraph(const QString &text, const QFont &font, qreal left, qreal width);

    std::vector<Sheet> take() { return std::move(m_sheets); }

private:
    ReportFonts m_fonts;
    std::vector<Sheet> m_sheets;
    qreal m_y;
};

// The same for any place of a sheet.
void placeText(Sheet &sheet, const QString &line, const QFont &font, const QRectF &room,
               SheetFlow::Align align);

} // namespace codewheel
