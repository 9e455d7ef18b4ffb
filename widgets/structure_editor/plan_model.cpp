// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/structure_editor/plan_model.h"

#include <algorithm>
#include <iterator>

namespace codewheel {

PlanModel::PlanModel(PlanEdits &edits, QObject *parent)
    : QAbstractItemModel(parent)
    , m_edits(edits)
    , m_document(edits.document())
{
    follow();
    connect(&m_document, &ProjectDocument::changed, this, &PlanModel::follow);
}

PlanModel::~PlanModel() = default;

void PlanModel::setBus(BusId bus, const QString &kind)
{
    m_edits.setBus(bus, kind);
    follow();
}

PlanModel::Node *PlanModel::nodeAt(const QModelIndex &index) const
{
    return index.isValid() ? static_cast<Node *>(index.internalPointer()) : const_cast<Node *>(&m_root);
}

QModelIndex PlanModel::indexOf(const Node &node, int column) const
{
    return createIndex(node.row, column, const_cast<Node *>(&node));
}

std::optional<PlanModel::Id> PlanModel::idAt(const QModelIndex &index) const
{
    return index.isValid() ? std::optional(nodeAt(index)->id) : std::nullopt;
}

QModelIndex PlanModel::indexOf(Id id, int column) const
{
    const auto node = m_nodes.find(id);
    return node == m_nodes.end() ? QModelIndex() : indexOf(*node->second, column);
}

std::vector<PlanModel::Id> PlanModel::find(const QString &text) const
{
    std::vector<Id> found;
    const QString wanted = text.trimmed();
    if (wanted.isEmpty())
        return found;
    for (const Id id : m_document.ids(m_edits.bus())) {
        const PlanRow &row = m_nodes.at(id)->shown;
        const QString place = row.place.toString();
        const auto has = [&](const QString &its) { return its.contains(wanted, Qt::CaseInsensitive); };
        // "2." does not match "12.0", but "12" matches "esc:12".
        if (place.startsWith(wanted) || place.section(u':', 1).startsWith(wanted, Qt::CaseInsensitive) ||
            std::ranges::any_of(
                row.codes + QStringList{row.station, row.group, row.note, row.serialNumber, row.name}, has))
            found.push_back(id);
    }
    return found;
}

std::vector<PlanModel::Id> PlanModel::withFindings() const
{
    std::vector<Id> found;
    std::ranges::copy_if(m_document.ids(m_edits.bus()), std::back_inserter(found),
                         [this](Id id) { return !m_nodes.at(id)->shown.findings.empty(); });
    return found;
}

QModelIndex PlanModel::index(int row, int column, const QModelIndex &parent) const
{
    if (column < 0 || column >= columnCount() || row < 0 || row >= rowCount(parent))
        return {};
    return createIndex(row, column, nodeAt(parent)->children[static_cast<std::size_t>(row)].get());
}

QModelIndex PlanModel::parent(const QModelIndex &index) const
{
    const Node *above = index.isValid() ? nodeAt(index)->parent : nullptr;
    return above == nullptr || above == &m_root ? QModelIndex() : indexOf(*above, 0);
}

int PlanModel::rowCount(const QModelIndex &parent) const
{
    return parent.column() > 0 ? 0 : static_cast<int>(nodeAt(parent)->children.size());
}

int PlanModel::columnCount(const QModelIndex &) const
{
    return static_cast<int>(m_columns.size());
}

} // namespace codewheel
