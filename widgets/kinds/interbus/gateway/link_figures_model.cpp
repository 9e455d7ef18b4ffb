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

std::vector<LinkFigureRow> LinkFiguresModel::rowsOf(const LinkFigures &figures)
{
    const QString none = QStringLiteral("\u2013");
    const auto &time = figures.roundTrip;
    std::vector<LinkFigureRow> rows{
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

LinkFiguresModel::LinkFiguresModel(QObject *parent)
    : TableModelBase(parent)
{
    setRows(rowsOf({}));
}

void LinkFiguresModel::show(const std::shared_ptr<const LinkFigures> &figures)
{
    if (figures == m_shown)
        return;
    m_shown = figures;
    std::vector<LinkFigureRow> fresh = rowsOf(figures ? *figures : LinkFigures());
    if (fresh.size() != rows().size()) {
        setRows(std::move(fresh));
        return;
    }
    for (int row = 0; row < rowCount(); ++row)
        if (LinkFigureRow &its = fresh[static_cast<std::size_t>(row)]; its != rowAt(row))
            replace(row, std::move(its));
}

QVariant LinkFiguresModel::rowHead(const LinkFigureRow &row, int role) const
{
    if (role == Qt::TextAlignmentRole)
        return QVariant(Qt::AlignLeft | Qt::AlignVCenter);
    if (role == Qt::ToolTipRole)
        return row.toolTip.isEmpty() ? row.title : row.toolTip;
    return role == Qt::DisplayRole ? row.title : QVariant();
}

QVariant LinkFiguresModel::cell(const LinkFigureRow &row, int /*column*/, int role) const
{
    switch (role) {
    case Qt::DisplayRole:
        return row.figure;
    case Qt::TextAlignmentRole:
        return QVariant(Qt::AlignRight | Qt::AlignVCenter);
    case Qt::FontRole:
        return numberFont();
    default:
        return {};
    }
}

} // namespace codewheel
