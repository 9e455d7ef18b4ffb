// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/structure_editor/plan_model.h"

#include "catalog/hex_code.h"

#include <algorithm>
#include <iterator>

namespace codewheel {

PlanModel::PlanModel(ProjectDocument &document, const Catalog &catalog, QObject *parent)
    : QAbstractItemModel(parent)
    , m_document(document)
    , m_catalog(catalog)
{
    follow();
    connect(&m_document, &ProjectDocument::changed, this, &PlanModel::follow);
}

PlanModel::~PlanModel() = default;

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

const PlanRow &PlanModel::rowAt(const QModelIndex &index) const
{
    return nodeAt(index)->shown;
}

std::vector<PlanModel::Id> PlanModel::find(const QString &text) const
{
    std::vector<Id> found;
    const QString wanted = text.trimmed();
    if (wanted.isEmpty())
        return found;
    for (const Id id : m_document.ids(m_ring)) {
        const PlanRow &row = m_nodes.at(id)->shown;
        const QString number = row.participant.number.toString();
        const QStringList places{row.station,
                                 row.group,
                                 row.note,
                                 row.serialNumber,
                                 row.name,
                                 hexCode(row.participant.idCode, 2),
                                 hexCode(row.participant.deviceCode, 4)};
        const auto has = [&](const QString &place) { return place.contains(wanted, Qt::CaseInsensitive); };
        if (number.startsWith(wanted) || std::ranges::any_of(places, has))
            found.push_back(id);
    }
    return found;
}

std::vector<PlanModel::Id> PlanModel::withFindings() const
{
    std::vector<Id> found;
    std::ranges::copy_if(m_document.ids(m_ring), std::back_inserter(found),
                         [this](Id id) { return !m_nodes.at(id)->shown.findings.empty(); });
    return found;
}

QModelIndex PlanModel::index(int row, int column, const QModelIndex &parent) const
{
    if (column < 0 || column >= columns || row < 0 || row >= rowCount(parent))
        return {};
    return createIndex(row, column, nodeAt(parent)->children[static_cast<std::size_t>(row)].get());
}

QModelIndex PlanModel::parent(const QModelIndex &index) const
{
    const Node *above = index.isValid() ? nodeAt(index)->parent : nullptr;
    return above == nullptr || above == &m_root ? QModelIndex() : indexOf(*above, numberColumn);
}

int PlanModel::rowCount(const QModelIndex &parent) const
{
    return parent.column() > 0 ? 0 : static_cast<int>(nodeAt(parent)->children.size());
}

int PlanModel::columnCount(const QModelIndex &) const
{
    return columns;
}

} // namespace codewheel
