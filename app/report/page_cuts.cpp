// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/page_cuts.h"

#include "app/report/sheet_format.h"

#include <QAbstractTextDocumentLayout>
#include <QTextBlock>
#include <QTextCursor>
#include <QTextDocument>
#include <QTextLayout>
#include <QTextTable>

#include <algorithm>
#include <limits>

namespace codewheel {
namespace {

constexpr qreal withHeading = sheet::mm(24); // of what follows must be on the same sheet

struct Span // from top to bottom
{
    qreal top = 0;
    qreal bottom = 0;
};

class Spans
{
public:
    explicit Spans(const QTextDocument &document);

    std::vector<PageCut> cut(qreal height);

private:
    QRectF rectOf(const QTextBlock &block) const
    {
        return m_document.documentLayout()->blockBoundingRect(block);
    }
    void addBlocks();
    void addTable(const QTextTable &table);
    std::vector<qreal> rowsOf(const QTextTable &table) const;
    QRectF headerAt(qreal y) const;
    static qreal above(const std::vector<Span> &spans, qreal y);

    const QTextDocument &m_document;
    std::vector<Span> m_lines;
    std::vector<Span> m_kept;                      // not to be cut
    std::vector<std::pair<Span, QRectF>> m_tables; // with their headers
};

Spans::Spans(const QTextDocument &document)
    : m_document(document)
{
    addBlocks();
    for (const QTextFrame *frame : document.rootFrame()->childFrames())
        if (const auto *table = qobject_cast<const QTextTable *>(frame))
            addTable(*table);
}

void Spans::addBlocks()
{
    qreal next = m_document.size().height(); // next heading or end, going up
    for (QTextBlock block = m_document.lastBlock(); block.isValid(); block = block.previous()) {
        const QRectF rect = rectOf(block);
        const QTextLayout &layout = *block.layout();
        const qreal offset = rect.top() - layout.boundingRect().top();
        for (int i = 0; i < layout.lineCount(); ++i)
            m_lines.push_back({offset + layout.lineAt(i).y(), offset + layout.lineAt(i).rect().bottom()});
        if (block.text().contains(QChar::ObjectReplacementCharacter))
            m_kept.push_back({rectOf(block.previous()).top(), rect.bottom()});
        if (block.blockFormat().headingLevel() == 0)
            continue;
        const bool isLast = next == m_document.size().height();
        m_kept.push_back({rect.top(), isLast ? next : std::min(next, rect.bottom() + withHeading)});
        next = rect.top();
    }
}

// The edges of its rows: halfway between the texts of two rows.
std::vector<qreal> Spans::rowsOf(const QTextTable &table) const
{
    std::vector<Span> texts;
    for (int row = 0; row < table.rows(); ++row) {
        Span &text = texts.emplace_back(Span{std::numeric_limits<qreal>::max(), 0});
        for (int column = 0; column < table.columns(); ++column) {
            const QTextTableCell cell = table.cellAt(row, column);
            text.top = std::min(text.top, rectOf(cell.firstCursorPosition().block()).top());
            text.bottom = std::max(text.bottom, rectOf(cell.lastCursorPosition().block()).bottom());
        }
    }
    const qreal padding = texts.size() < 2 ? 0 : (texts[1].top - texts[0].bottom) / 2;
    std::vector<qreal> rows{texts.front().top - padding};
    for (std::size_t row = 1; row < texts.size(); ++row)
        rows.push_back((texts[row - 1].bottom + texts[row].top) / 2);
    rows.push_back(texts.back().bottom + padding);
    return rows;
}

void Spans::addTable(const QTextTable &table)
{
    const std::vector<qreal> rows = rowsOf(table);
    for (std::size_t row = 0; row + 1 < rows.size(); ++row)
        m_kept.push_back({rows[row], rows[row + 1]});
    if (table.format().headerRowCount() == 0 || rows.size() < 3)
        return;
    m_kept.push_back({rows[0], rows[2]});
    m_tables.push_back({{rows[1], rows.back()}, {0, rows[0], sheet::body.width(), rows[1] - rows[0]}});
}

QRectF Spans::headerAt(qreal y) const
{
    for (const auto &[rows, header] : m_tables)
        if (rows.top < y && y < rows.bottom)
            return header;
    return {};
}

// The lowest place at or above y that cuts none of the spans.
qreal Spans::above(const std::vector<Span> &spans, qreal y)
{
    const auto isCut = [&](const Span &span) { return span.top < y && y < span.bottom; };
    for (auto span = std::ranges::find_if(spans, isCut); span != spans.end();
         span = std::ranges::find_if(spans, isCut))
        y = span->top;
    return y;
}

std::vector<PageCut> Spans::cut(qreal height)
{
    std::erase_if(m_kept, [&](const Span &span) { return span.bottom - span.top > height; });
    std::vector<Span> all = m_kept;
    all.insert(all.end(), m_lines.begin(), m_lines.end());
    const qreal end = std::ranges::max_element(all, {}, &Span::bottom)->bottom;
    std::vector<PageCut> cuts;
    for (qreal top = 0; top < end;) {
        const QRectF header = headerAt(top);
        const qreal limit = top + height - header.height();
        qreal bottom = limit >= end ? end : above(all, limit);
        if (bottom <= top)
            bottom = above(m_lines, limit);
        if (bottom <= top)
            bottom = limit;
        cuts.push_back({top, bottom, header});
        top = end;
        for (const Span &span : all)
            if (span.bottom > bottom)
                top = std::min(top, std::max(span.top, bottom));
    }
    return cuts;
}

} // namespace

std::vector<PageCut> pageCuts(const QTextDocument &document, qreal height)
{
    return Spans(document).cut(height);
}

} // namespace codewheel
