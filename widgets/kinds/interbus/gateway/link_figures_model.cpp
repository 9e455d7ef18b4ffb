// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/interbus/gateway/link_figures_model.h"

#include "vocabulary/sentence.h"
#include "widgets/look/fonts.h"

#include <QLocale>

namespace codewheel {
namespace {

QString milliseconds(Instant time)
{
    return QLocale().toString(std::chrono::duration<double, std::milli>(time).count(), 'f', 1);
}

QString countText(std::uint64_t count)
{
    return QLocale().toString(qulonglong{count});
}

} // namespace

std::vector<LinkFiguresModel::Row> LinkFiguresModel::rowsOf(const LinkFigures &figures)
{
    const QString none = QStringLiteral("\u2013");
    const auto &time = figures.roundTrip;
    std::vector<Row> rows{
        {tr("Exchanges per second"), QLocale().toString(figures.exchangesPerSecond, 'f', 1)},
        {tr("Exchanges"), countText(figures.exchanges)},
        {tr("Transactions"), countText(figures.transactions)},
        {tr("Retries"), countText(figures.retries)},
        {tr("Time-outs"), countText(figures.noAnswers)},
        {tr("Wrong answers"), countText(figures.wrongAnswers)},
        {tr("Connections"), countText(figures.connections)},
        {tr("Closed while idle"), countText(figures.reconnections),
         tr("Connections that the gateway closed while nothing was sent")},
        {tr("Connections lost"), countText(figures.closed)},
        {tr("Stray bytes"), countText(figures.strayBytes)},
        {tr("Echoes of requests"), countText(figures.echoes)},
        {tr("Words not believed"), countText(figures.tornWords)},
        {tr("Round trip, shortest, ms"), time ? milliseconds(time->shortest) : none},
        {tr("Round trip, median, ms"), time ? milliseconds(time->median) : none},
        {tr("Round trip, longest, ms"), time ? milliseconds(time->longest) : none},
    };
    if (figures.closesAfterEach)
        rows.push_back({tr("Closed after each answer"), countText(figures.closedAfterEach),
                        tr("Connections that the gateway closed after an answer")});
    for (const auto &[code, count] : figures.exceptions)
        rows.push_back({sentence(tr("Exceptions %1"), {QString::number(code)}), countText(count)});
    return rows;
}

void LinkFiguresModel::show(const std::shared_ptr<const LinkFigures> &figures)
{
    if (figures == m_shown)
        return;
    m_shown = figures;
    std::vector<Row> rows = rowsOf(figures ? *figures : LinkFigures());
    if (rows.size() != m_rows.size()) {
        beginResetModel();
        m_rows = std::move(rows);
        endResetModel();
        return;
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (rows[i] == m_rows[i])
            continue;
        m_rows[i] = std::move(rows[i]);
        const QModelIndex changed = index(static_cast<int>(i), 0);
        Q_EMIT dataChanged(changed, changed);
    }
}

int LinkFiguresModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int LinkFiguresModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : 1;
}

QVariant LinkFiguresModel::data(const QModelIndex &index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid | CheckIndexOption::ParentIsInvalid))
        return {};
    switch (role) {
    case Qt::DisplayRole:
        return m_rows[static_cast<std::size_t>(index.row())].figure;
    case Qt::TextAlignmentRole:
        return QVariant(Qt::AlignRight | Qt::AlignVCenter);
    case Qt::FontRole:
        return numberFont();
    default:
        return {};
    }
}

QVariant LinkFiguresModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation == Qt::Horizontal || section < 0 || section >= rowCount())
        return {};
    if (role == Qt::TextAlignmentRole)
        return QVariant(Qt::AlignLeft | Qt::AlignVCenter);
    const Row &row = m_rows[static_cast<std::size_t>(section)];
    if (role == Qt::ToolTipRole)
        return row.toolTip.isEmpty() ? row.title : row.toolTip;
    return role == Qt::DisplayRole ? row.title : QVariant();
}

} // namespace codewheel
