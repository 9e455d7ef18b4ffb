// SPDX-License-Identifier: GPL-3.0-or-later
// The branch of the serial line in the tree.
#include "catalog/device_description.h"
#include "line/line_session.h"
#include "widgets/look/icons.h"
#include "widgets/structure/structure_ids.h"
#include "widgets/structure/structure_model.h"

#include <algorithm>

namespace codewheel {

using namespace structure_ids;

void StructureModel::setLine(LineSession *line)
{
    if (m_line.line())
        m_line.line()->disconnect(this);
    m_line.setLine(line);
    rebuild();
    if (!line)
        return;
    connect(line, &LineSession::updated, this, &StructureModel::refreshLine);
    connect(line, &LineSession::stateChanged, this, &StructureModel::refreshLine);
    connect(line, &LineSession::nodesChanged, this, [this] {
        insertNewEncoders();
        removeGoneEncoders();
    });
    connect(line, &LineSession::moved, this, [this](Place from, Place to) {
        insertNewEncoders();
        Q_EMIT encoderMoved(from, to);
        removeGoneEncoders();
    });
}

QModelIndex StructureModel::lineIndex() const
{
    return m_line.line() ? createIndex(hasRing() ? 1 : 0, deviceColumn, lineId) : QModelIndex();
}

bool StructureModel::isLine(const QModelIndex &index) const
{
    return index.isValid() && index.internalId() == lineId;
}

const LineBranch::Row *StructureModel::lineRow(const QModelIndex &index) const
{
    if (!index.isValid() || index.internalId() <= lineId)
        return nullptr;
    const auto found = std::ranges::find_if(m_lineRows, [&](const LineBranch::Row &row) {
        return encoderId(LineAddress::of(row.number.node)) == index.internalId();
    });
    return found == m_lineRows.end() ? nullptr : &*found;
}

QModelIndex StructureModel::lineRowIndex(Place number, int column) const
{
    const auto found = std::ranges::find(m_lineRows, number, &LineBranch::Row::number);
    if (found == m_lineRows.end())
        return {};
    return createIndex(static_cast<int>(found - m_lineRows.begin()), column,
                       encoderId(LineAddress::of(number.node)));
}

void StructureModel::insertNewEncoders()
{
    for (const LineBranch::Row &row : m_line.rows(m_project)) {
        const auto at = std::ranges::lower_bound(m_lineRows, row.number, {}, &LineBranch::Row::number);
        if (at != m_lineRows.end() && at->number == row.number)
            continue;
        const int place = static_cast<int>(at - m_lineRows.begin());
        beginInsertRows(lineIndex(), place, place);
        m_lineRows.insert(at, row);
        endInsertRows();
    }
}

void StructureModel::removeGoneEncoders()
{
    const std::vector<LineBranch::Row> there = m_line.rows(m_project);
    for (std::size_t place = m_lineRows.size(); place-- > 0;) {
        if (std::ranges::find(there, m_lineRows[place].number, &LineBranch::Row::number) != there.end())
            continue;
        const int row = static_cast<int>(place);
        beginRemoveRows(lineIndex(), row, row);
        m_lineRows.erase(m_lineRows.begin() + row);
        endRemoveRows();
    }
}

// Only what changed is told to the views.
void StructureModel::refreshLine()
{
    if (!m_line.line())
        return;
    if (Shown shown = m_line.state(); shown != m_lineShown) {
        m_lineShown = std::move(shown);
        emitState(lineIndex());
    }
    for (LineBranch::Row &row : m_line.rows(m_project)) {
        const auto shown = std::ranges::find(m_lineRows, row.number, &LineBranch::Row::number);
        if (shown == m_lineRows.end() || *shown == row)
            continue;
        const bool isOnlyPosition =
            shown->shown == row.shown && shown->name == row.name && shown->station == row.station;
        *shown = std::move(row);
        Q_EMIT dataChanged(lineRowIndex(shown->number, isOnlyPosition ? positionColumn : deviceColumn),
                           lineRowIndex(shown->number, positionColumn));
    }
}

QVariant StructureModel::lineCell(int column, int role) const
{
    if (role == Qt::ToolTipRole)
        return m_line.toolTip();
    if (role == Qt::DisplayRole && column == deviceColumn)
        return m_line.name();
    if (role == Qt::DisplayRole && column == stateColumn)
        return m_lineShown.word;
    if (role == Qt::DecorationRole && column == deviceColumn)
        return lineIcon(Icon::ring);
    if (role == Qt::DecorationRole && column == stateColumn)
        return lineIcon(roleIcon(m_lineShown.role), m_lineShown.role);
    return {};
}

QVariant StructureModel::lineEncoderCell(const LineBranch::Row &row, int column, int role) const
{
    if (role == Qt::ToolTipRole)
        return m_line.toolTip(row);
    if (column == positionColumn && row.isOld)
        if (QVariant look = oldPositionLook(row.position, role); look.isValid())
            return look;
    if (role == Qt::DecorationRole && column == deviceColumn)
        return lineIcon(Icon::encoder);
    if (role == Qt::DecorationRole && column == stateColumn)
        return lineIcon(roleIcon(row.shown.role), row.shown.role);
    if (role != Qt::DisplayRole)
        return {};
    switch (column) {
    case deviceColumn:
        return QStringLiteral("%1  %2").arg(row.number.toString(), calledText(row.station, row.name));
    case stateColumn:
        return row.shown.word;
    case positionColumn:
        return positionText(row.position);
    case profileColumn:
        return profileName(Profile::esc);
    case idCodeColumn:
        return LineAddress::of(row.number.node).shown();
    default:
        return {};
    }
}

} // namespace codewheel
