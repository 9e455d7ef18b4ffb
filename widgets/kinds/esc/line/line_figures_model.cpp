// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/esc/line/line_figures_model.h"

#include "widgets/look/fonts.h"

#include <QLocale>

#include <algorithm>

namespace codewheel {
namespace {

// A count, or a time.
struct FigureRow
{
    const char *title;
    std::uint64_t LineFigures::*count;
    Instant AnswerTime::*time;
};

constexpr FigureRow figureRows[] = {
    {QT_TRANSLATE_NOOP("codewheel::LineFiguresModel", "Requests"), &LineFigures::requests, {}},
    {QT_TRANSLATE_NOOP("codewheel::LineFiguresModel", "Answers"), &LineFigures::answers, {}},
    {QT_TRANSLATE_NOOP("codewheel::LineFiguresModel", "Time-outs"), &LineFigures::timeOuts, {}},
    {QT_TRANSLATE_NOOP("codewheel::LineFiguresModel", "Retries"), &LineFigures::retries, {}},
    {QT_TRANSLATE_NOOP("codewheel::LineFiguresModel", "Unanswered"), &LineFigures::unanswered, {}},
    {QT_TRANSLATE_NOOP("codewheel::LineFiguresModel", "Garbage bytes"), &LineFigures::garbageBytes, {}},
    {QT_TRANSLATE_NOOP("codewheel::LineFiguresModel", "Late bytes"), &LineFigures::lateBytes, {}},
    {QT_TRANSLATE_NOOP("codewheel::LineFiguresModel", "Answer time, shortest, ms"),
     {},
     &AnswerTime::shortest},
    {QT_TRANSLATE_NOOP("codewheel::LineFiguresModel", "Answer time, median, ms"), {}, &AnswerTime::median},
    {QT_TRANSLATE_NOOP("codewheel::LineFiguresModel", "Answer time, longest, ms"), {}, &AnswerTime::longest},
};
constexpr int figureCount = static_cast<int>(std::size(figureRows));

QString figureText(const LineFigures &figures, const FigureRow &row)
{
    if (row.count != nullptr)
        return QLocale().toString(qulonglong{figures.*row.count});
    if (!figures.answerTime)
        return QStringLiteral("\u2013");
    const std::chrono::duration<double, std::milli> time = *figures.answerTime.*row.time;
    return QLocale().toString(time.count(), 'f', 1);
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

QVariant LineFiguresModel::data(const QModelIndex &index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid | CheckIndexOption::ParentIsInvalid))
        return {};
    switch (role) {
    case Qt::DisplayRole:
        return figureText(m_columns[static_cast<std::size_t>(index.column())].figures,
                          figureRows[index.row()]);
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
        if (role == Qt::TextAlignmentRole)
            return QVariant(Qt::AlignRight | Qt::AlignVCenter); // above its figures
        if (role != Qt::DisplayRole || section < 0 || section >= columnCount())
            return {};
        const auto &address = m_columns[static_cast<std::size_t>(section)].address;
        return address ? address->shown() : tr("Line");
    }
    if (role == Qt::TextAlignmentRole)
        return QVariant(Qt::AlignLeft | Qt::AlignVCenter);
    const bool isTitle = role == Qt::DisplayRole && section >= 0 && section < figureCount;
    return isTitle ? tr(figureRows[section].title) : QVariant();
}

} // namespace codewheel
