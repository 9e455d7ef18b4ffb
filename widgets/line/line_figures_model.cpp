// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/line/line_figures_model.h"

#include "widgets/look/fonts.h"

#include <QLocale>

#include <algorithm>

namespace codewheel {
namespace {

QString millisecondText(Instant time)
{
    constexpr double microseconds = 1'000.0;
    return QLocale().toString(static_cast<double>(time.count()) / microseconds, 'f', 1);
}

QString countText(std::uint64_t count)
{
    return QLocale().toString(qulonglong{count});
}

} // namespace

void LineFiguresModel::show(const LineSnapshot &line)
{
    std::vector<Column> fresh{{{}, line.figures}};
    for (const LineSnapshot::Device &device : line.devices)
        if (device.present)
            fresh.push_back({device.address, device.figures});
    if (!std::ranges::equal(fresh, m_columns, {}, &Column::address, &Column::address)) {
        beginResetModel();
        m_columns = std::move(fresh);
        endResetModel();
        return;
    }
    for (std::size_t column = 0; column < fresh.size(); ++column) {
        if (fresh[column] == m_columns[column])
            continue;
        m_columns[column] = fresh[column];
        const int changed = static_cast<int>(column);
        Q_EMIT dataChanged(index(0, changed), index(figureCount - 1, changed));
    }
}

int LineFiguresModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : figureCount;
}

int LineFiguresModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_columns.size());
}

QString LineFiguresModel::text(const LineFigures &figures, int figure)
{
    switch (figure) {
    case requests:
        return countText(figures.requests);
    case answers:
        return countText(figures.answers);
    case timeOuts:
        return countText(figures.timeOuts);
    case retries:
        return countText(figures.retries);
    case unanswered:
        return countText(figures.unanswered);
    case garbageBytes:
        return countText(figures.garbageBytes);
    case lateBytes:
        return countText(figures.lateBytes);
    default:
        break;
    }
    if (!figures.answerTime)
        return QStringLiteral("\u2013");
    const auto &time = *figures.answerTime;
    return millisecondText(figure == shortest ? time.shortest
                           : figure == median ? time.median
                                              : time.longest);
}

QVariant LineFiguresModel::data(const QModelIndex &index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid | CheckIndexOption::ParentIsInvalid))
        return {};
    switch (role) {
    case Qt::DisplayRole:
        return text(m_columns[static_cast<std::size_t>(index.column())].figures, index.row());
    case Qt::TextAlignmentRole:
        return QVariant(Qt::AlignRight | Qt::AlignVCenter);
    case Qt::FontRole:
        return numberFont();
    default:
        return {};
    }
}

QVariant LineFiguresModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation == Qt::Horizontal) {
        if (role != Qt::DisplayRole || section < 0 || section >= columnCount())
            return {};
        const auto &address = m_columns[static_cast<std::size_t>(section)].address;
        return address ? address->shown() : tr("Line");
    }
    if (role == Qt::TextAlignmentRole)
        return QVariant(Qt::AlignLeft | Qt::AlignVCenter);
    if (role != Qt::DisplayRole)
        return {};
    switch (section) {
    case requests:
        return tr("Requests");
    case answers:
        return tr("Answers");
    case timeOuts:
        return tr("Time-outs");
    case retries:
        return tr("Retries");
    case unanswered:
        return tr("Unanswered");
    case garbageBytes:
        return tr("Garbage bytes");
    case lateBytes:
        return tr("Late bytes");
    case shortest:
        return tr("Answer time, shortest, ms");
    case median:
        return tr("Answer time, median, ms");
    case longest:
        return tr("Answer time, longest, ms");
    default:
        return {};
    }
}

} // namespace codewheel
