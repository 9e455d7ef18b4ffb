// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/line/line_row_model.h"

#include "esc_line/typed_request.h"
#include "widgets/look/fonts.h"

#include <QLocale>

namespace codewheel {
namespace {

// Dropped at once, so that it is seldom.
constexpr int rowsDropped = 5'000;

bool isSending(const ShownLineRow &row, const esc::Request &request)
{
    return row.row.what.kind == esc::LineRow::Kind::sent && row.request == request;
}

} // namespace

bool ShownLineRow::isPoll() const
{
    using Kind = esc::LineRow::Kind;
    const bool isWrong = row.what.kind == Kind::garbage || row.what.kind == Kind::late;
    return !row.typed && !isWrong && request && request->command == esc::Command::position;
}

LineRowModel::LineRowModel(QObject *parent)
    : TrafficModelBase(mostRows, rowsDropped, parent)
{}

void LineRowModel::setBegin(const QDateTime &begin)
{
    m_begin = begin;
}

void LineRowModel::setExplainOptions(const esc::ExplainOptions &options)
{
    m_options = options;
    if (rowCount() > 0)
        Q_EMIT dataChanged(index(0, meaning), index(rowCount() - 1, meaning));
}

ShownLineRow LineRowModel::shown(LineRecord::Row row)
{
    if (row.what.kind == esc::LineRow::Kind::sent)
        m_lastRequest = sentRequest(row.what.bytes);
    return {std::move(row), m_lastRequest};
}

void LineRowModel::add(const esc::LineRow &row)
{
    addWaiting(shown({.what = row}));
}

// It was sent once, and all that came since came in answer to it.
void LineRowModel::markTyped(const esc::Request &request)
{
    for (auto waiting = waitingRows().rbegin(); waiting != waitingRows().rend(); ++waiting) {
        waiting->row.typed = true;
        if (isSending(*waiting, request))
            return;
    }
    for (int row = rowCount() - 1; row >= 0; --row) {
        ShownLineRow marked = rowAt(row);
        marked.row.typed = true;
        const bool isFirst = isSending(marked, request);
        replace(row, std::move(marked));
        if (isFirst)
            return;
    }
}

void LineRowModel::setRecord(const LineRecord &record)
{
    m_begin = record.begin;
    m_lastRequest.reset();
    std::vector<ShownLineRow> rows;
    rows.reserve(record.rows.size());
    for (const LineRecord::Row &row : record.rows)
        rows.push_back(shown(row));
    setRows(std::move(rows));
    Q_EMIT countsChanged();
}

std::vector<LineRecord::Row> LineRowModel::recordRows() const
{
    std::vector<LineRecord::Row> kept;
    for (const auto *part : {&rows(), &waitingRows()})
        for (const ShownLineRow &row : *part)
            kept.push_back(row.row);
    if (kept.size() > LineRecord::mostRows)
        kept.erase(kept.begin(), kept.end() - static_cast<std::ptrdiff_t>(LineRecord::mostRows));
    return kept;
}

QDateTime LineRowModel::dateTime(const ShownLineRow &row) const
{
    return m_begin.addMSecs(std::chrono::duration_cast<std::chrono::milliseconds>(row.row.what.at).count());
}

QString LineRowModel::dateTimeText(const ShownLineRow &row) const
{
    return dateTime(row).toString(Qt::ISODateWithMs);
}

QString LineRowModel::cellText(const ShownLineRow &row, int column, ControlCharacters controls) const
{
    const esc::LineRow &what = row.row.what;
    switch (column) {
    case time:
        return dateTime(row).toString(QStringLiteral("hh:mm:ss.zzz"));
    case kind:
        return row.row.typed ? tr("%1, typed", "sent, answer ...").arg(rowKindWord(what.kind))
                             : rowKindWord(what.kind);
    case text:
        return controlText(what.bytes, controls);
    case bytes:
        return byteText(what.bytes);
    default:
        return rowMeaning(what, row.request, m_options);
    }
}

QVariant LineRowModel::headerCell(int column, int role) const
{
    if (role == Qt::TextAlignmentRole)
        return QVariant(Qt::AlignLeft | Qt::AlignVCenter);
    if (role != Qt::DisplayRole)
        return {};
    switch (column) {
    case time:
        return tr("Time");
    case kind:
        return tr("Direction");
    case text:
        return tr("Text");
    case bytes:
        return tr("Hex");
    default:
        return tr("Meaning");
    }
}

QVariant LineRowModel::cell(const ShownLineRow &row, int column, int role) const
{
    switch (role) {
    case Qt::DisplayRole:
        return cellText(row, column);
    case Qt::DecorationRole:
        return column == kind ? QVariant(rowKindIcon(row.row.what.kind)) : QVariant();
    case Qt::ToolTipRole:
        return column == time ? QLocale().toString(dateTime(row), QLocale::LongFormat)
                              : cellText(row, column);
    case Qt::FontRole:
        return column == time || column == text || column == bytes ? QVariant(numberFont()) : QVariant();
    case Qt::TextAlignmentRole:
        return QVariant(Qt::AlignLeft | Qt::AlignVCenter);
    default:
        return {};
    }
}

} // namespace codewheel
