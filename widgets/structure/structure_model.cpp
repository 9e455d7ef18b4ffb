// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/structure/structure_model.h"

#include "bus/word_channel.h"
#include "catalog/catalog.h"
#include "project/bus_kind.h"
#include "widgets/models/dragged_place.h"
#include "widgets/project/project_document.h"

#include <algorithm>

namespace codewheel {
namespace {

bool hangSame(const std::vector<BusBranch::Row> &rows, const std::vector<BusNode> &nodes)
{
    return std::ranges::equal(rows, nodes, [](const BusBranch::Row &row, const BusNode &node) {
        return row.node.node == node.node && row.node.parent == node.parent &&
               row.node.isCoupler == node.isCoupler;
    });
}

bool isSameNode(const BusBranch::Row &row, const BusBranch::Row &before)
{
    return row.node.node == before.node.node && row.node.parent == before.node.parent &&
           row.node.code == before.node.code && row.node.words == before.node.words &&
           row.node.deviceCode == before.node.deviceCode;
}

bool isFlat(const std::vector<BusNode> &nodes)
{
    return std::ranges::none_of(nodes, [](const BusNode &node) { return node.parent.has_value(); });
}

QString titleOf(const BusBranch &branch)
{
    const BusOutline &outline = branch.outline();
    const QString name = Place{branch.bus, {}}.shown();
    const std::optional<QString> behind = outline.behindName();
    if (name.isEmpty() || !behind)
        return calledText(nameAmongOthers(branch.bus), outline.title());
    return behind->isEmpty() ? name : QStringLiteral("%1 (%2)").arg(name, *behind);
}

} // namespace

StructureModel::StructureModel(QObject *parent)
    : QAbstractItemModel(parent)
{}

void StructureModel::setProject(const ProjectDocument &project, const Catalog &catalog)
{
    m_project = &project;
    m_catalog = &catalog;
    connect(&project, &ProjectDocument::changed, this, &StructureModel::followProject);
    rebuild();
}

void StructureModel::addBus(EncoderBus &bus)
{
    bus.disconnect(this);
    BusBranch *branch = find(bus.id());
    if (branch == nullptr) // rebuild() sorts; until then the others stay where their indexes say
        branch = &m_branches.emplace_back(BusBranch{.bus = bus.id()});
    branch->connected = &bus;
    rebuild();
    followBus(bus);
}

void StructureModel::removeBus(BusId bus)
{
    BusBranch *branch = find(bus);
    if (branch == nullptr || branch->connected == nullptr)
        return;
    std::exchange(branch->connected, nullptr)->disconnect(this);
    rebuild();
}

void StructureModel::followBus(EncoderBus &bus)
{
    const BusId id = bus.id();
    connect(&bus, &EncoderBus::updated, this, [this, id] { refresh(id); });
    connect(&bus, &EncoderBus::stateChanged, this, [this, id] { refresh(id); });
    connect(&bus, &EncoderBus::nodesChanged, this, [this, id] { takeNodes(id); });
    connect(&bus, &EncoderBus::moved, this,
            [this, id](Place from, Place to) { takeNodes(id, std::pair(from, to)); });
    followWords(bus);
}

// With other devices, the words may have changed.
void StructureModel::followWords(EncoderBus &bus)
{
    const BusId id = bus.id();
    for (const Place place : bus.places())
        if (WordChannel *channel = bus.channel(place)) {
            channel->disconnect(this);
            connect(channel, &WordChannel::stagedChanged, this, [this, id] { refresh(id); });
        }
}

std::vector<EncoderBus *> StructureModel::connected() const
{
    std::vector<EncoderBus *> buses;
    for (const BusBranch &branch : m_branches)
        if (branch.connected)
            buses.push_back(branch.connected);
    return buses;
}

// A new project has no plan yet, so its ring is not worth a row.
bool StructureModel::isShown(const PlannedBus &bus) const
{
    const Project &project = m_project->project();
    const bool isNew = project.buses == usualBuses() && project.devices.empty();
    return busKind(bus.kind) != nullptr && !isNew;
}

std::vector<BusBranch> StructureModel::branches()
{
    std::vector<BusBranch> all;
    for (EncoderBus *bus : connected())
        all.push_back({.bus = bus->id(), .connected = bus});
    if (m_project != nullptr)
        for (const PlannedBus &bus : m_project->project().buses)
            if (isShown(bus) && std::ranges::find(all, bus.id, &BusBranch::bus) == all.end())
                all.push_back(
                    {.bus = bus.id,
                     .planned = busKind(bus.kind)->outline(m_project->project(), bus.id, *m_catalog)});
    std::ranges::sort(all, {}, &BusBranch::bus);
    for (BusBranch &branch : all) {
        branch.id = ++m_lastId;
        branch.title = titleOf(branch);
        branch.state = branch.outline().state();
        branch.mode = branch.modeNow();
        const std::vector<BusNode> nodes = branch.outline().nodes();
        for (std::size_t i = 0; i < nodes.size(); ++i)
            branch.rows.push_back(branch.make(++m_lastId, i, nodes[i], m_project));
        branch.arrange();
    }
    return all;
}

void StructureModel::show(std::vector<BusBranch> branches)
{
    beginResetModel();
    m_branches = std::move(branches);
    noteWhere();
    endResetModel();
}

void StructureModel::noteWhere()
{
    m_where.clear();
    for (std::size_t i = 0; i < m_branches.size(); ++i) {
        m_where.insert(m_branches[i].id, {i, {}});
        for (std::size_t row = 0; row < m_branches[i].rows.size(); ++row)
            m_where.insert(m_branches[i].rows[row].id, {i, row});
    }
}

// The project supplies only the stations of connected buses: that one of their devices has moved, they tell
// themselves. A change of make or station keeps the row, and with it the selection.
void StructureModel::followProject()
{
    std::vector<BusBranch> now = branches();
    const bool isSame = std::ranges::equal(now, m_branches, [](const BusBranch &one, const BusBranch &other) {
        return one.bus == other.bus && one.connected == other.connected &&
               (one.connected != nullptr || std::ranges::equal(one.rows, other.rows, isSameNode));
    });
    if (!isSame) {
        show(std::move(now));
        return;
    }
    for (std::size_t i = 0; i < now.size(); ++i) {
        m_branches[i].planned = now[i].planned;
        const std::vector<BusNode> nodes = m_branches[i].outline().nodes();
        if (hangSame(m_branches[i].rows, nodes))
            showNames(m_branches[i], nodes);
    }
    showTitles();
}

void StructureModel::showTitles()
{
    for (BusBranch &branch : m_branches)
        if (std::exchange(branch.title, titleOf(branch)) != branch.title)
            Q_EMIT dataChanged(indexOf(branch, deviceColumn), indexOf(branch, deviceColumn));
}

// The devices, or their places, have changed. Surviving rows keep their identity.
void StructureModel::takeNodes(BusId bus, std::optional<std::pair<Place, Place>> moved)
{
    BusBranch *branch = find(bus);
    if (branch == nullptr || branch->connected == nullptr)
        return;
    const std::vector<BusNode> nodes = branch->outline().nodes();
    followWords(*branch->connected);
    if (hangSame(branch->rows, nodes)) {
        showNames(*branch, nodes);
        return;
    }
    if (!branch->isFlat() || !isFlat(nodes)) {
        rebuild();
        return;
    }
    insertNew(*branch, nodes);
    if (moved)
        Q_EMIT deviceMoved(moved->first, moved->second);
    removeGone(*branch, nodes);
    showNames(*branch, nodes);
}

void StructureModel::insertNew(BusBranch &branch, const std::vector<BusNode> &nodes)
{
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const auto at = std::ranges::lower_bound(branch.rows, nodes[i].node, {},
                                                 [](const Row &row) { return row.node.node; });
        if (at != branch.rows.end() && at->node.node == nodes[i].node)
            continue;
        const int place = static_cast<int>(at - branch.rows.begin());
        beginInsertRows(indexOf(branch, 0), place, place);
        branch.rows.insert(at, branch.make(++m_lastId, i, nodes[i], m_project));
        branch.arrange();
        noteWhere();
        endInsertRows();
    }
}

void StructureModel::removeGone(BusBranch &branch, const std::vector<BusNode> &nodes)
{
    for (std::size_t place = branch.rows.size(); place-- > 0;) {
        if (std::ranges::find(nodes, branch.rows[place].node.node, &BusNode::node) != nodes.end())
            continue;
        const int row = static_cast<int>(place);
        beginRemoveRows(indexOf(branch, 0), row, row);
        branch.rows.erase(branch.rows.begin() + row);
        branch.arrange();
        noteWhere();
        endRemoveRows();
    }
}

void StructureModel::showNames(BusBranch &branch, const std::vector<BusNode> &nodes)
{
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        Row &row = branch.rows[i];
        row.isOther = branch.isOther(nodes[i], m_project);
        const QString station = branch.stationOf(nodes[i], m_project);
        if (row.node == nodes[i] && row.station == station)
            continue;
        row.node = nodes[i];
        row.station = station;
        Q_EMIT dataChanged(indexOf(branch, i, 0), indexOf(branch, i, columns - 1));
    }
    refresh(branch.bus);
}

// Notifies the views only of changes: most frames change no state at all.
void StructureModel::refresh(BusId bus)
{
    BusBranch *branch = find(bus);
    if (branch == nullptr)
        return;
    const StateWord state = branch->outline().state();
    const QString mode = branch->modeNow();
    if (state != branch->state || mode != branch->mode) {
        branch->state = state;
        branch->mode = mode;
        Q_EMIT dataChanged(indexOf(*branch, deviceColumn), indexOf(*branch, positionColumn));
    }
    for (std::size_t i = 0; i < branch->rows.size(); ++i)
        refreshRow(*branch, branch->rows[i], branch->stateOf(i));
}

void StructureModel::refreshRow(const BusBranch &branch, Row &row, const NodeState &state)
{
    if (row.state == state)
        return;
    const bool isOnlyPosition = row.state.shown == state.shown && row.state.isCutOff == state.isCutOff &&
                                row.state.isBehindBreak == state.isBehindBreak;
    row.state = state;
    const auto place = static_cast<std::size_t>(&row - branch.rows.data());
    const int first = isOnlyPosition ? positionColumn : deviceColumn;
    Q_EMIT dataChanged(indexOf(branch, place, first), indexOf(branch, place, positionColumn));
}

BusBranch *StructureModel::find(BusId bus)
{
    const auto found = std::ranges::find(m_branches, bus, &BusBranch::bus);
    return found == m_branches.end() ? nullptr : &*found;
}

const BusBranch *StructureModel::find(BusId bus) const
{
    const auto found = std::ranges::find(m_branches, bus, &BusBranch::bus);
    return found == m_branches.end() ? nullptr : &*found;
}

const StructureModel::Where *StructureModel::whereIs(const QModelIndex &index) const
{
    const auto where = index.isValid() ? m_where.constFind(index.internalId()) : m_where.constEnd();
    return where == m_where.constEnd() ? nullptr : &*where;
}

const StructureModel::Row *StructureModel::rowAt(const QModelIndex &index) const
{
    const Where *where = whereIs(index);
    return where != nullptr && where->row ? &m_branches[where->branch].rows[*where->row] : nullptr;
}

QModelIndex StructureModel::indexOf(const BusBranch &branch, std::size_t row, int column) const
{
    return createIndex(static_cast<int>(branch.rows[row].place), column, branch.rows[row].id);
}

QModelIndex StructureModel::indexOf(const BusBranch &branch, int column) const
{
    return createIndex(static_cast<int>(&branch - m_branches.data()), column, branch.id);
}

std::optional<Place> StructureModel::placeAt(const QModelIndex &index) const
{
    const Row *row = rowAt(index);
    return row != nullptr ? std::optional(Place{m_branches[whereIs(index)->branch].bus, row->node.node})
                          : std::nullopt;
}

std::optional<BusId> StructureModel::busAt(const QModelIndex &index) const
{
    const Where *where = whereIs(index);
    return where != nullptr && !where->row ? std::optional(m_branches[where->branch].bus) : std::nullopt;
}

QModelIndex StructureModel::indexOf(Place place) const
{
    const BusBranch *branch = find(place.bus);
    const auto row = branch != nullptr ? branch->find(place.node) : std::nullopt;
    return row ? indexOf(*branch, *row, deviceColumn) : QModelIndex();
}

QModelIndex StructureModel::indexOf(BusId bus) const
{
    const BusBranch *branch = find(bus);
    return branch != nullptr ? indexOf(*branch, deviceColumn) : QModelIndex();
}

bool StructureModel::makeIsOpen(Place place) const
{
    const BusBranch *branch = find(place.bus);
    const auto row = branch != nullptr && branch->connected ? branch->find(place.node) : std::nullopt;
    return row && branch->rows[*row].node.makeIsOpen;
}

QModelIndex StructureModel::index(int row, int column, const QModelIndex &parent) const
{
    if (column < 0 || column >= columns || row < 0 || row >= rowCount(parent))
        return {};
    const auto place = static_cast<std::size_t>(row);
    if (!parent.isValid())
        return indexOf(m_branches[place], column);
    const Where &above = *whereIs(parent);
    const BusBranch &branch = m_branches[above.branch];
    return indexOf(branch, (above.row ? branch.rows[*above.row].children : branch.top)[place], column);
}

QModelIndex StructureModel::parent(const QModelIndex &index) const
{
    const Row *row = rowAt(index);
    if (row == nullptr)
        return {};
    const BusBranch &branch = m_branches[whereIs(index)->branch];
    return row->node.parent ? indexOf(branch, *row->node.parent, deviceColumn)
                            : indexOf(branch, deviceColumn);
}

int StructureModel::rowCount(const QModelIndex &parent) const
{
    if (parent.column() > 0)
        return 0;
    if (!parent.isValid())
        return static_cast<int>(m_branches.size());
    const Row *row = rowAt(parent);
    const Where *where = whereIs(parent);
    if (row != nullptr)
        return static_cast<int>(row->children.size());
    return where != nullptr ? static_cast<int>(m_branches[where->branch].top.size()) : 0;
}

int StructureModel::columnCount(const QModelIndex &) const
{
    return columns;
}

Qt::ItemFlags StructureModel::flags(const QModelIndex &index) const
{
    const Qt::ItemFlags flags = QAbstractItemModel::flags(index);
    return placeAt(index) ? flags | Qt::ItemIsDragEnabled : flags;
}

QMimeData *StructureModel::mimeData(const QModelIndexList &indexes) const
{
    for (const QModelIndex &index : indexes)
        if (const auto place = placeAt(index)) {
            QStringList texts;
            for (const Column column : {deviceColumn, stateColumn, positionColumn})
                texts << index.siblingAtColumn(column).data().toString();
            return draggedPlace(*place, texts.join(u'\t')).release();
        }
    return nullptr;
}

} // namespace codewheel
