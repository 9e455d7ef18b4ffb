// SPDX-License-Identifier: GPL-3.0-or-later
// How the rows follow the project: rows still in order stay, others are moved, added or removed.
#include "widgets/structure_editor/plan_model.h"

#include <algorithm>
#include <unordered_set>
#include <utility>

namespace codewheel {

struct PlanModel::Target
{
    struct Place
    {
        Id parent = 0; // 0: the bus itself
        int row = 0;
        std::size_t device = 0;
    };

    std::unordered_map<Id, Place> places;
    std::unordered_map<Id, std::vector<Id>> children;
    std::vector<PlanRow> rows; // in the order of the bus

    bool has(Id id) const { return places.contains(id); }
    const std::vector<Id> &childrenOf(Id parent) const
    {
        static const std::vector<Id> none;
        const auto found = children.find(parent);
        return found == children.end() ? none : found->second;
    }
};

namespace {

// The longest rising subsequence of these numbers, as indices.
std::vector<std::size_t> longestRising(const std::vector<int> &numbers)
{
    std::vector<std::size_t> lastOf;                 // index of the smallest end of a run, by its length
    std::vector<std::size_t> before(numbers.size()); // the previous index in its run
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const auto at = std::ranges::lower_bound(lastOf, numbers[i], {},
                                                 [&](std::size_t index) { return numbers[index]; });
        before[i] = at == lastOf.begin() ? numbers.size() : *(at - 1);
        if (at == lastOf.end())
            lastOf.push_back(i);
        else
            *at = i;
    }
    std::vector<std::size_t> run;
    for (std::size_t i = lastOf.empty() ? numbers.size() : lastOf.back(); i < numbers.size(); i = before[i])
        run.push_back(i);
    return run;
}

} // namespace

void PlanModel::follow()
{
    showColumns();
    const std::span<const Id> ids = m_document.ids(m_edits.bus());
    Target target;
    target.rows = m_edits.rows();
    for (std::size_t device = 0; device < ids.size(); ++device) {
        const auto above = target.rows[device].parent;
        const Id parent = above ? ids[*above] : 0;
        std::vector<Id> &children = target.children[parent];
        target.places[ids[device]] = {parent, static_cast<int>(children.size()), device};
        children.push_back(ids[device]);
    }
    // From the top: a row has to be in its place before those below it.
    arrange(m_root, target);
    for (const Id id : ids)
        if (target.children.contains(id))
            arrange(*m_nodes.at(id), target);
    removeOthers(m_root, target);
    showRows(m_root, target);
}

// Another kind has other columns.
void PlanModel::showColumns()
{
    std::vector<PlanColumn> columns = m_edits.rules().columns(m_edits.project(), m_edits.bus());
    if (columns.size() != m_columns.size()) {
        beginResetModel();
        m_root.children.clear();
        m_nodes.clear();
        m_columns = std::move(columns);
        endResetModel();
    } else if (std::exchange(m_columns, columns) != columns) {
        Q_EMIT headerDataChanged(Qt::Horizontal, 0, columnCount() - 1);
    }
}

void PlanModel::arrange(Node &parent, const Target &target)
{
    std::vector<int> rows; // of the children that belong here
    std::vector<Id> belonging;
    for (const auto &child : parent.children)
        if (const auto place = target.places.find(child->id);
            place != target.places.end() && place->second.parent == parent.id) {
            rows.push_back(place->second.row);
            belonging.push_back(child->id);
        }
    std::unordered_set<Id> staying;
    for (const std::size_t i : longestRising(rows))
        staying.insert(belonging[i]);

    int row = 0;
    for (const Id id : target.childrenOf(parent.id)) {
        // Rows that do not stay are removed later.
        while (row < std::ssize(parent.children) &&
               !staying.contains(parent.children[static_cast<std::size_t>(row)]->id))
            ++row;
        const auto known = m_nodes.find(id);
        if (staying.contains(id)) {
            ++row;
        } else if (known == m_nodes.end()) {
            insertAt(parent, row++, id, target);
        } else {
            Node &node = *known->second;
            const bool wasBefore = node.parent == &parent && node.row < row;
            moveTo(node, parent, row);
            if (!wasBefore)
                ++row;
        }
    }
}

// row: counted while the node is still in its old place.
void PlanModel::moveTo(Node &node, Node &parent, int row)
{
    Node &from = *node.parent;
    const int source = node.row;
    const bool isSame = &from == &parent;
    if (isSame && (row == source || row == source + 1))
        return;
    const auto indexOfParent = [this](const Node &of) {
        return &of == &m_root ? QModelIndex() : indexOf(of, 0);
    };
    if (!beginMoveRows(indexOfParent(from), source, source, indexOfParent(parent), row))
        return;
    std::unique_ptr<Node> taken = std::move(from.children[static_cast<std::size_t>(source)]);
    from.children.erase(from.children.begin() + source);
    const int to = isSame && source < row ? row - 1 : row;
    taken->parent = &parent;
    parent.children.insert(parent.children.begin() + to, std::move(taken));
    countRows(from);
    countRows(parent);
    endMoveRows();
}

void PlanModel::insertAt(Node &parent, int row, Id id, const Target &target)
{
    beginInsertRows(&parent == &m_root ? QModelIndex() : indexOf(parent, 0), row, row);
    auto node = std::make_unique<Node>();
    node->id = id;
    node->parent = &parent;
    node->shown = target.rows[target.places.at(id).device];
    m_nodes[id] = node.get();
    parent.children.insert(parent.children.begin() + row, std::move(node));
    countRows(parent);
    endInsertRows();
}

void PlanModel::removeOthers(Node &parent, const Target &target)
{
    for (int last = static_cast<int>(parent.children.size()) - 1; last >= 0;) {
        const auto isGone = [&](int row) {
            return !target.has(parent.children[static_cast<std::size_t>(row)]->id);
        };
        if (!isGone(last)) {
            removeOthers(*parent.children[static_cast<std::size_t>(last)], target);
            --last;
            continue;
        }
        int first = last;
        while (first > 0 && isGone(first - 1))
            --first;
        beginRemoveRows(&parent == &m_root ? QModelIndex() : indexOf(parent, 0), first, last);
        parent.children.erase(parent.children.begin() + first, parent.children.begin() + last + 1);
        countRows(parent);
        endRemoveRows();
        last = first - 1;
    }
    if (&parent == &m_root)
        std::erase_if(m_nodes, [&](const auto &node) { return !target.has(node.first); });
}

// Notifies of changed rows, adjacent ones together.
void PlanModel::showRows(Node &parent, const Target &target)
{
    int first = -1;
    const auto tell = [&](int end) {
        if (first >= 0)
            Q_EMIT dataChanged(
                indexOf(*parent.children[static_cast<std::size_t>(first)], 0),
                indexOf(*parent.children[static_cast<std::size_t>(end - 1)], columnCount() - 1));
        first = -1;
    };
    for (int row = 0; row < std::ssize(parent.children); ++row) {
        Node &node = *parent.children[static_cast<std::size_t>(row)];
        const PlanRow &shown = target.rows[target.places.at(node.id).device];
        if (node.shown == shown) {
            tell(row);
        } else {
            node.shown = shown;
            if (first < 0)
                first = row;
        }
    }
    tell(static_cast<int>(parent.children.size()));
    for (const auto &child : parent.children)
        if (!child->children.empty())
            showRows(*child, target);
}

void PlanModel::countRows(Node &parent)
{
    int row = 0;
    for (const auto &child : parent.children)
        child->row = row++;
}

} // namespace codewheel
