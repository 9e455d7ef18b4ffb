// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTextLayout>

class QPainter;

namespace codewheel {

// Its short parentheses are not broken: "(by hand)" goes to the next line whole.
QString withWholeParentheses(const QString &text);

// A text wrapped to a width between words, and within a word longer than a line: for delegates that must not
// cut anything off.
class WrappedText
{
public:
    WrappedText(const QString &text, const QFont &font, int width, Qt::Alignment alignment);

    int height() const;
    // In the painter's colour, centred vertically in `where`.
    void draw(QPainter &painter, const QRect &where) const;

private:
    QTextLayout m_layout;
};

} // namespace codewheel
