// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/esc/line/replay_model.h"

#include "widgets/look/fonts.h"
#include "widgets/look/roles.h"
#include "widgets/models/traffic_model.h"

#include <algorithm>

namespace codewheel {
namespace {

QIcon verdictIcon(const ReplayRow &row)
{
    if (!row.verdict)
        return {};
    switch (*row.verdict) {
    case EscLineReplay::Verdict::same:
        return lineIcon(Icon::ok, Role::running);
    case EscLineReplay::Verdict::differs:
        return lineIcon(Icon::attention, Role::attention);
    case EscLineReplay::Verdict::noAnswer:
        break;
    }
    return lineIcon(Icon::fault, Role::fault);
}

} // namespace

void ReplayModel::setSteps(const std::vector<ReplayStep> &steps)
{
    std::vector<ReplayRow> rows;
    rows.reserve(steps.size());
    for (const ReplayStep &step : steps)
        rows.push_back({step, {}, {}});
    setRows(std::move(rows));
}

void ReplayModel::setAnswer(int row, EscLineReplay::Verdict verdict, const QByteArray &answer)
{
    replace(row, {rowAt(row).step, verdict, answer});
}

int ReplayModel::count(EscLineReplay::Verdict verdict) const
{
    return static_cast<int>(std::ranges::count(rows(), std::optional(verdict), &ReplayRow::verdict));
}

QString ReplayModel::text(const ReplayRow &row, int column) const
{
    switch (column) {
    case meaning:
        return esc::requestText(row.step.request, m_options);
    case request:
        return QString::fromLatin1(row.step.request.text());
    case then:
        if (!row.step.answer)
            return tr("none", "answer");
        return row.step.answer->isEmpty() ? tr("accepted") : controlText(*row.step.answer, shownControls());
    case now:
        if (!row.verdict || *row.verdict == EscLineReplay::Verdict::noAnswer ||
            (*row.verdict == EscLineReplay::Verdict::same && !row.step.answer))
            return row.verdict ? tr("none", "answer") : QString();
        return row.now.isEmpty() ? tr("accepted") : controlText(row.now, shownControls());
    default:
        break;
    }
    if (!row.verdict)
        return esc::shapeOf(row.step.request.command).writes ? tr("not sent; writes") : tr("not sent");
    switch (*row.verdict) {
    case EscLineReplay::Verdict::same:
        return tr("same");
    case EscLineReplay::Verdict::differs:
        return tr("differs");
    case EscLineReplay::Verdict::noAnswer:
        break;
    }
    return tr("no answer");
}

std::span<const ColumnHead> ReplayModel::heads() const
{
    static constexpr ColumnHead all[] = {{QT_TR_NOOP("Meaning"), Qt::AlignLeft},
                                         {QT_TR_NOOP("Request"), Qt::AlignLeft},
                                         {QT_TR_NOOP("Saved answer"), Qt::AlignLeft},
                                         {QT_TR_NOOP("Answer now"), Qt::AlignLeft},
                                         {QT_TR_NOOP("Result"), Qt::AlignLeft}};
    return all;
}

QVariant ReplayModel::cell(const ReplayRow &row, int column, int role) const
{
    if (role == Qt::DecorationRole && column == result)
        return verdictIcon(row);
    return TableModelBase::cell(row, column, role);
}

} // namespace codewheel
