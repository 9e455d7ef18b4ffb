// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/trace/trace_model.h"

#include "encoder/asked_word.h"
#include "encoder/hex.h"
#include "widgets/look/fonts.h"

#include <QLocale>

namespace codewheel {

namespace {

// Dropped at once, so that it is seldom.
constexpr int traceRowsDropped = 500;

} // namespace

TraceModel::TraceModel(DeviceDescription device, QObject *parent)
    : TableModelBase(parent)
    , m_device(std::move(device))
{}

void TraceModel::add(const Exchange &exchange, const QDateTime &at)
{
    TraceRow row{.exchange = exchange,
                 .asked = askedWord(exchange, m_last ? &*m_last : nullptr),
                 .at = at,
                 .sinceLast = {},
                 .remark = {}};
    if (m_last && exchange.at >= m_last->at)
        row.sinceLast = exchange.at - m_last->at;
    m_last = exchange;
    if (m_held)
        m_waiting.push_back(std::move(row));
    else
        append({std::move(row)});
    dropOldest();
    Q_EMIT countsChanged();
}

// While it is held nothing that is looked at goes; what waits is bounded by itself.
void TraceModel::dropOldest()
{
    if (m_held && waiting() > mostRows) {
        m_waiting.erase(m_waiting.begin(), m_waiting.begin() + traceRowsDropped);
        m_dropped += traceRowsDropped;
    } else if (!m_held && rowCount() > mostRows) {
        const int surplus = std::max(rowCount() - mostRows, traceRowsDropped);
        removeFirst(surplus);
        m_dropped += static_cast<quint64>(surplus);
    }
}

void TraceModel::setHeld(bool held)
{
    m_held = held;
    if (!held) {
        append(std::exchange(m_waiting, {}));
        dropOldest();
    }
    Q_EMIT countsChanged();
}

void TraceModel::clear()
{
    clearRows(std::exchange(m_waiting, {}), mostRows);
    m_last.reset();
    m_droppedBefore += std::exchange(m_dropped, 0);
    Q_EMIT countsChanged();
}

void TraceModel::bringBack()
{
    bringRowsBack();
    m_dropped += std::exchange(m_droppedBefore, 0);
    dropOldest();
    Q_EMIT countsChanged();
}

Qt::ItemFlags TraceModel::flags(const QModelIndex &index) const
{
    const Qt::ItemFlags usual = TableModelBase::flags(index);
    return index.column() == remark ? usual | Qt::ItemIsEditable : usual;
}

bool TraceModel::setData(const QModelIndex &index, const QVariant &value, int role)
{
    if (!index.isValid() || role != Qt::EditRole || index.column() != remark)
        return false;
    TraceRow row = rowAt(index.row());
    row.remark = value.toString().simplified();
    replace(index.row(), std::move(row));
    return true;
}

QVariant TraceModel::headerCell(int column, int role) const
{
    const bool isNumber = column == sinceLast || column == cycle;
    if (role == Qt::TextAlignmentRole)
        return QVariant((isNumber ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    if (column == sinceLast && (role == Qt::ToolTipRole || role == Qt::AccessibleTextRole))
        return tr("Since last, ms");
    if (role != Qt::DisplayRole)
        return {};
    switch (column) {
    case time:
        return tr("Time");
    case sinceLast:
        return QStringLiteral("\u0394 ms");
    case cycle:
        return tr("Cycle");
    case out:
        return QStringLiteral("OUT");
    case in:
        return QStringLiteral("IN");
    case meaning:
        return tr("Meaning");
    default:
        return tr("Remark");
    }
}

QString TraceModel::text(const TraceRow &row, int column) const
{
    switch (column) {
    case time:
        return clockText(row);
    case sinceLast:
        return sinceLastText(row);
    case cycle:
        return QLocale().toString(static_cast<qulonglong>(row.exchange.cycle));
    case out:
        return hexWord(row.exchange.out);
    case in:
        return hexWord(row.exchange.in);
    case meaning:
        return exchangeText(m_device, row);
    default:
        return row.remark;
    }
}

QVariant TraceModel::cell(const TraceRow &row, int column, int role) const
{
    switch (role) {
    case Qt::DisplayRole:
        return text(row, column);
    case Qt::EditRole:
        return column == remark ? QVariant(row.remark) : QVariant();
    case Qt::ToolTipRole:
        if (column == time)
            return traceTimeText(row);
        return column == meaning || column == remark ? QVariant(text(row, column)) : QVariant();
    case Qt::FontRole:
        return column < meaning ? QVariant(numberFont()) : QVariant();
    case Qt::TextAlignmentRole:
        return QVariant((column == sinceLast || column == cycle ? Qt::AlignRight : Qt::AlignLeft) |
                        Qt::AlignVCenter);
    default:
        return {};
    }
}

} // namespace codewheel
