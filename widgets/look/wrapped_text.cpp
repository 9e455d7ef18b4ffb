// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/wrapped_text.h"

#include <QPainter>

#include <algorithm>

namespace codewheel {

QString withWholeParentheses(const QString &text)
{
    constexpr qsizetype longest = 12; // letters; more leave too little to break
    QString whole = text;
    for (qsizetype open = text.indexOf(u'('); open >= 0; open = text.indexOf(u'(', open + 1)) {
        const qsizetype close = text.indexOf(u')', open);
        for (qsizetype at = open; at < close && close - open < longest; ++at)
            if (text[at] == u' ')
                whole[at] = QChar::Nbsp;
    }
    return whole;
}

WrappedText::WrappedText(const QString &text, const QFont &font, int width, Qt::Alignment alignment)
    : m_layout(withWholeParentheses(text), font)
{
    QTextOption option(alignment & Qt::AlignHorizontal_Mask);
    option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
    m_layout.setTextOption(option);
    m_layout.beginLayout();
    double top = 0;
    for (QTextLine line = m_layout.createLine(); line.isValid(); line = m_layout.createLine()) {
        line.setLineWidth(std::max(width, 1));
        line.setPosition({0, top});
        top += line.height();
    }
    m_layout.endLayout();
}

int WrappedText::height() const
{
    return qCeil(m_layout.boundingRect().height());
}

void WrappedText::draw(QPainter &painter, const QRect &where) const
{
    const int above = (where.height() - height()) / 2;
    m_layout.draw(&painter, where.topLeft() + QPoint(0, above));
}

} // namespace codewheel
