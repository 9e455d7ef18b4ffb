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
    : TrafficModelBase(mostRows, traceRowsDropped, parent)
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
    addWaiting(std::move(row));
    showWaiting();
}

void TraceModel::clear()
{
    TrafficModelBase::clear();
    m_last.reset();
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
