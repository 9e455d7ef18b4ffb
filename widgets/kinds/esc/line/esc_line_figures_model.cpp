// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/esc/line/esc_line_figures_model.h"

#include "widgets/look/fonts.h"

#include <QLocale>

#include <algorithm>

namespace codewheel {
namespace {

// A count, or a time.
struct FigureRow
{
    const char *title;
    std::uint64_t EscLineFigures::*count;
    Instant AnswerTime::*time;
};

constexpr FigureRow figureRows[] = {
    {QT_TRANSLATE_NOOP("codewheel::EscLineFiguresModel", "Requests"), &EscLineFigures::requests, {}},
    {QT_TRANSLATE_NOOP("codewheel::EscLineFiguresModel", "Answers"), &EscLineFigures::answers, {}},
    {QT_TRANSLATE_NOOP("codewheel::EscLineFiguresModel", "Time-outs"), &EscLineFigures::timeOuts, {}},
    {QT_TRANSLATE_NOOP("codewheel::EscLineFiguresModel", "Retries"), &EscLineFigures::retries, {}},
    {QT_TRANSLATE_NOOP("codewheel::EscLineFiguresModel", "Unanswered"), &EscLineFigures::unanswered, {}},
    {QT_TRANSLATE_NOOP("codewheel::EscLineFiguresModel", "Garbage bytes"), &EscLineFigures::garbageBytes, {}},
    {QT_TRANSLATE_NOOP("codewheel::EscLineFiguresModel", "Late bytes"), &EscLineFigures::lateBytes, {}},
    {QT_TRANSLATE_NOOP("codewheel::EscLineFiguresModel", "Answer time, shortest, ms"),
     {},
     &AnswerTime::shortest},
    {QT_TRANSLATE_NOOP("codewheel::EscLineFiguresModel", "Answer time, median, ms"), {}, &AnswerTime::median},
    {QT_TRANSLATE_NOOP("codewheel::EscLineFiguresModel", "Answer time, longest, ms"),
     {},
     &AnswerTime::longest},
};
constexpr int figureCount = static_cast<int>(std::size(figureRows));

QString figureText(const EscLineFigures &figures, const FigureRow &row)
{
    if (row.count != nullptr)
        return QLocale().toString(qulonglong{figures.*row.count});
    if (!figures.answerTime)
        return QStringLiteral("\u2013");
    const std::chrono::duration<double, std::milli> time = *figures.answerTime.*row.time;
    return QLocale().toString(time.count(), 'f', 1);
}

} // namespace

void EscLineFiguresModel::show(const EscLineSnapshot &line)
{
    std::vector<Column> fresh{{{}, line.figures}};
    for (const EscLineSnapshot::Device &device : line.devices)
        if (device.present)
            fresh.push_back({EscLineAddress::of(device.node), device.figures});
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

int EscLineFiguresModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : figureCount;
}

int EscLineFiguresModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_columns.size());
}

QVariant EscLineFiguresModel::data(const QModelIndex &index, int role) const
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

QVariant EscLineFiguresModel::headerData(int section, Qt::Orientation orientation, int role) const
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
