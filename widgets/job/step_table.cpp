// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/job/step_table.h"

#include "catalog/device_description.h"
#include "jobs/step_text.h"
#include "jobs/write_plan.h"
#include "vocabulary/hex.h"
#include "widgets/look/fonts.h"
#include "widgets/look/icons.h"
#include "widgets/look/roles.h"

#include <QCoreApplication>

namespace codewheel {
namespace {

struct StateLook
{
    QString text;
    QVariant icon;
};

StateLook lookOf(StepState state)
{
    switch (state) {
    case StepState::planned:
        break;
    case StepState::next:
        return {StepTable::tr("next"), lineIcon(Icon::next)};
    case StepState::sent:
        return {StepTable::tr("sent"), lineIcon(Icon::step)};
    case StepState::done:
        return {StepTable::tr("done"), lineIcon(Icon::ok, Role::running)};
    case StepState::failed:
        return {StepTable::tr("failed"), lineIcon(Icon::fault, Role::fault)};
    }
    return {};
}

} // namespace

StepTable::StepTable(Stage stage, QObject *parent)
    : TableModelBase(parent)
    , m_stage(stage)
{}

void StepTable::showSteps(const DeviceDescription &device, const std::vector<Step> &steps)
{
    if (m_isOnLine != !device.hasWords()) {
        m_isOnLine = !device.hasWords();
        setRows({});
    }
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const int at = static_cast<int>(i);
        StepRow row{.step = steps[i], .what = stepText(device, steps[i]), .in = {}};
        if (at >= rowCount())
            append({row});
        else if (rowAt(at).step != steps[i])
            replace(at, row);
    }
    while (rowCount() > static_cast<int>(steps.size()))
        removeAt(rowCount() - 1);
}

void StepTable::goOnFrom(const DeviceDescription &device, std::vector<StepRow> rows, int current)
{
    m_isOnLine = !device.hasWords();
    for (StepRow &row : rows)
        row.what = stepText(device, row.step);
    setRows(std::move(rows));
    m_current = current;
}

void StepTable::begin()
{
    m_current = -1;
    setRows({});
}

void StepTable::setCurrent(int index, bool waitsForUser)
{
    for (int i = 0; i < rowCount() && i < index; ++i)
        setState(i, StepState::done);
    m_current = index;
    if (index >= 0 && index < rowCount())
        setState(index, waitsForUser ? StepState::next : StepState::sent);
}

// A row is reported before the step that follows from it: it belongs to the last step that put this word out.
void StepTable::answer(const Exchange &row)
{
    for (int i = std::min(m_current, rowCount() - 1); i >= 0 && row.isAnswered; --i) {
        const StepRow &of = rowAt(i);
        if (of.step.out != row.out || of.state == StepState::next || of.state == StepState::planned)
            continue;
        if (of.state == StepState::done && of.in)
            return; // what comes behind its answer is not of it
        StepRow answered = of;
        answered.in = row.in;
        if (answered != of)
            replace(i, answered);
        return;
    }
}

void StepTable::finish(bool ok)
{
    for (int i = 0; i < rowCount(); ++i)
        if (rowAt(i).state == StepState::sent || (ok && rowAt(i).state == StepState::next))
            setState(i, ok ? StepState::done : StepState::failed);
        else if (rowAt(i).state == StepState::next)
            setState(i, StepState::planned);
}

void StepTable::setState(int row, StepState to)
{
    if (rowAt(row).state == to)
        return;
    StepRow changed = rowAt(row);
    changed.state = to;
    replace(row, changed);
}

QVariant StepTable::headerCell(int column, int role) const
{
    if (role == Qt::TextAlignmentRole)
        return int(Qt::AlignLeft | Qt::AlignVCenter);
    if (role != Qt::DisplayRole)
        return {};
    switch (meaningOf(column)) {
    case what:
        return tr("Step");
    case out:
        return m_isOnLine ? tr("Request") : tr("OUT");
    case in:
        return tr("IN");
    default:
        return tr("State");
    }
}

QVariant StepTable::cell(const StepRow &row, int at, int role) const
{
    const Column column = meaningOf(at);
    if (role == Qt::FontRole && (column == out || column == in))
        return numberFont();
    if (role == Qt::FontRole && column == what && row.state == StepState::next) {
        QFont strong = textFont();
        strong.setBold(true);
        return strong;
    }
    if (role == Qt::DecorationRole && column == state)
        return lookOf(row.state).icon;
    if (role != Qt::DisplayRole && role != Qt::ToolTipRole)
        return {};
    switch (column) {
    case what:
        return row.what;
    case out:
        return sentText(row.step);
    case in:
        return row.in ? hexWord(*row.in) : QString();
    default:
        return lookOf(row.state).text;
    }
}

} // namespace codewheel
