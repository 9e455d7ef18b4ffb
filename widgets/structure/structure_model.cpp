// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/structure/structure_model.h"

#include "bus/word_channel.h"
#include "catalog/catalog.h"
#include "catalog/device_description.h"
#include "catalog/hex_code.h"
#include "encoder/device_error_name.h"
#include "project/project_take_over.h"
#include "ring/bus_session.h"
#include "ring/device_leds.h"
#include "ring/ring_tree.h"
#include "widgets/master/master_look.h"
#include "widgets/models/age_text.h"
#include "widgets/models/device_traits.h"
#include "widgets/project/project_document.h"
#include "widgets/structure/structure_ids.h"

#include <QGuiApplication>
#include <QPalette>

#include <algorithm>
#include <iterator>

namespace codewheel {

using namespace structure_ids;

namespace {

QString idCodeText(unsigned code)
{
    return QStringLiteral("%1 = %2").arg(hexCode(code, 2)).arg(code);
}

QString profileText(const DeviceDescription *device)
{
    return device ? profileName(device->profile) : QStringLiteral("-");
}

// By its number, as the manual's table has it; 0 is none of them. An LA-66 has but one error, and names it.
QString errorText(const EncoderSession *encoder, const Reading &reading)
{
    const unsigned number = reading.errorNumber.value_or(0);
    const DeviceError *error = encoder == nullptr ? nullptr : encoder->device().findError(number);
    if (error != nullptr && isRod(encoder->device()))
        return deviceErrorName(error->meaning);
    if (number == 0)
        return deviceErrorName(RefusalId::noValidPosition);
    return StructureModel::tr("error %1").arg(number);
}

} // namespace

// Grey, and said to those who do not see it.
QVariant StructureModel::oldPositionLook(std::optional<std::int64_t> position, int role)
{
    if (role == Qt::ForegroundRole)
        return QGuiApplication::palette().brush(QPalette::PlaceholderText);
    if (role == Qt::AccessibleTextRole && position)
        return tr("%1, not up to date", "a position").arg(positionText(position));
    return {};
}

StructureModel::StructureModel(QObject *parent)
    : QAbstractItemModel(parent)
{}

void StructureModel::setBus(BusSession *bus)
{
    if (m_bus != nullptr)
        m_bus->disconnect(this);
    m_bus = bus;
    rebuild();
    if (bus != nullptr)
        followBus();
}

void StructureModel::setProject(const ProjectDocument &project, const Catalog &catalog)
{
    m_project = &project;
    m_catalog = &catalog;
    connect(&project, &ProjectDocument::changed, this, &StructureModel::followProject);
    rebuild();
}

void StructureModel::followBus()
{
    connect(m_bus, &BusSession::updated, this, &StructureModel::refresh);
    connect(m_bus, &BusSession::stateChanged, this, &StructureModel::refresh);
    connect(m_bus, &BusSession::named, this, &StructureModel::showName);
    for (const Place number : m_bus->places())
        if (WordChannel *channel = m_bus->channel(number))
            connect(channel, &WordChannel::stagedChanged, this, &StructureModel::refresh);
}

RingStructure StructureModel::ring() const
{
    if (m_bus != nullptr)
        return m_bus->structure();
    return m_project == nullptr ? RingStructure() : structureOf(m_project->project(), firstRing);
}

void StructureModel::rebuild()
{
    beginResetModel();
    m_nodes.clear();
    const RingStructure participants = ring();
    const RingTree tree = ringTree(participants);
    const auto indices = [](const std::vector<std::size_t> &places) {
        return std::vector<int>(places.begin(), places.end());
    };
    m_remote = indices(tree.mainLine);
    for (std::size_t place = 0; place < participants.size(); ++place) {
        Node node = nodeOf(participants[place]);
        const RingTree::Node &hangs = tree.nodes[place];
        node.parent = hangs.parent ? static_cast<int>(*hangs.parent) : -1;
        node.children = indices(hangs.localBus);
        std::ranges::copy(indices(hangs.branch), std::back_inserter(node.children));
        m_nodes.push_back(std::move(node));
    }
    m_master = shownOfMaster();
    for (std::size_t place = 0; place < m_nodes.size(); ++place)
        m_nodes[place].shown = shownOf(m_nodes[place], place);
    m_lineShown = m_line.state();
    m_lineRows = m_line.rows(m_project);
    endResetModel();
}

// Offline the rows are the project's; connected it has but the stations. Another make or station is no other
// row: what is chosen stays so.
void StructureModel::followProject()
{
    const RingStructure participants = ring();
    RingStructure shown;
    std::ranges::transform(m_nodes, std::back_inserter(shown), &Node::participant);
    if (!isSameRing(participants, shown)) {
        rebuild();
        return;
    }
    for (std::size_t place = 0; place < participants.size(); ++place)
        showNames(place, participants[place]);
    refreshLine();
}

QString StructureModel::stationOf(const Participant &participant) const
{
    if (m_project == nullptr)
        return {};
    const ProjectDevice &planned = m_project->device(placeOf(participant));
    return planned.participant.deviceCode == participant.deviceCode ? planned.station : QString();
}

StructureModel::Node StructureModel::nodeOf(const Participant &participant) const
{
    const EncoderSession *encoder = m_bus == nullptr ? nullptr : m_bus->encoder(participant.number);
    const DeviceDescription *device = encoder == nullptr ? nullptr : &encoder->device();
    if (m_bus == nullptr && m_catalog != nullptr) {
        const DeviceDescription *named = m_catalog->find(participant.deviceKey);
        device = named ? named : m_catalog->generic(participant.deviceCode);
    }
    return {.participant = participant,
            .name = participantName(participant, device),
            .station = stationOf(participant),
            .profile = profileText(device),
            .children = {},
            .shown = {},
            .position = {}};
}

void StructureModel::showName(Place number)
{
    const QModelIndex row = indexOf(number);
    if (!row.isValid())
        return;
    const auto place = static_cast<std::size_t>(nodeOf(row));
    showNames(place, m_bus->structure()[place]);
}

void StructureModel::showNames(std::size_t place, const Participant &participant)
{
    Node &node = m_nodes[place];
    const Node named = nodeOf(participant);
    if (node.participant == named.participant && node.name == named.name && node.station == named.station &&
        node.profile == named.profile)
        return;
    node.participant = named.participant;
    node.name = named.name;
    node.station = named.station;
    node.profile = named.profile;
    const QModelIndex row = indexOf(placeOf(participant));
    Q_EMIT dataChanged(row, row.siblingAtColumn(columns - 1));
}

// Only what changed is told to the views: most pictures change no state at all.
void StructureModel::refresh()
{
    if (m_nodes.empty() && m_bus == nullptr)
        return;
    const Shown master = shownOfMaster();
    if (master != m_master) {
        m_master = master;
        emitState(index(0, deviceColumn));
    }
    for (std::size_t place = 0; place < m_nodes.size(); ++place) {
        Shown shown = shownOf(m_nodes[place], place);
        if (shown == m_nodes[place].shown)
            continue;
        m_nodes[place].shown = std::move(shown);
        emitState(indexOf(placeOf(m_nodes[place].participant)));
    }
    refreshPositions();
}

void StructureModel::refreshPositions()
{
    if (m_bus == nullptr)
        return;
    const std::size_t count = std::min(m_nodes.size(), m_bus->latest().devices.size());
    for (std::size_t place = 0; place < count; ++place) {
        Node &shown = m_nodes[place];
        const EncoderSession *encoder = m_bus->encoder(shown.participant.number);
        const auto position = m_bus->latest().devices[place].reading.position;
        const bool isOld = encoder != nullptr && encoder->freshness().isOld();
        if (position == shown.position && isOld == shown.isOld)
            continue;
        shown.position = position;
        shown.isOld = isOld;
        const int node = static_cast<int>(place);
        const QModelIndex cell = createIndex(rowOf(node), positionColumn, static_cast<quintptr>(place) + 1);
        Q_EMIT dataChanged(cell, cell);
    }
}

void StructureModel::emitState(const QModelIndex &row)
{
    Q_EMIT dataChanged(row.siblingAtColumn(deviceColumn), row.siblingAtColumn(stateColumn));
}

StructureModel::Shown StructureModel::shownOfMaster() const
{
    if (m_bus == nullptr)
        return {Role::inactive, tr("offline")};
    return {masterRole(m_bus->latest()), masterText(m_bus->latest())};
}

StructureModel::Shown StructureModel::shownOf(const Node &node, std::size_t place) const
{
    if (m_bus == nullptr)
        return {Role::inactive, tr("planned")};
    if (place >= m_bus->latest().devices.size())
        return {Role::inactive, tr("not seen yet")};
    const Snapshot::Device &device = m_bus->latest().devices[place];
    const WordChannel *channel = m_bus->channel(node.participant.number);
    if (auto fault = faultOf(node, place))
        return *fault;
    if (!device.inRing)
        return {Role::inactive, tr("not in the ring")};
    if (!m_bus->isRunning())
        return {Role::inactive, tr("stopped")};
    const bool exchanged = m_bus->latest().cycle > 0;
    if (exchanged && m_bus->encoder(node.participant.number) == nullptr) // no driver that could tell more
        return {Role::running, tr("ok")};
    if (device.reading.state == EncoderState::error)
        return {Role::fault, errorText(m_bus->encoder(node.participant.number), device.reading)};
    if (device.heldByJob)
        return {Role::attention, tr("job running")};
    if (channel != nullptr && channel->staged())
        return {Role::attention, tr("OUT not sent")};
    switch (device.reading.state) {
    case EncoderState::parameterization:
        return {Role::attention, tr("parameterization")};
    case EncoderState::readOut:
        return {Role::attention, tr("read-out")};
    case EncoderState::service:
        return {Role::attention, tr("service mode")};
    case EncoderState::silent:
        return {Role::fault, tr("silent")};
    case EncoderState::unknown:
        return {Role::attention, tr("unknown state")};
    case EncoderState::notSeen:
        return {Role::inactive, tr("not seen yet")};
    case EncoderState::operation:
    case EncoderState::error:
        break;
    }
    return {Role::running, tr("ok")};
}

// What the master says of this very device.
std::optional<StructureModel::Shown> StructureModel::faultOf(const Node &node, std::size_t place) const
{
    const MasterStatus *master = m_bus->master();
    if (master == nullptr)
        return std::nullopt;
    const auto at = master->faultPlace();
    if (at && at->number == node.participant.number)
        return Shown{Role::fault, master->faultText()};
    if (place < master->devices.size() && master->devices[place].peripheralFault)
        return Shown{Role::fault, busFaultText(bus_error::peripheralFault,
                                               diagnosticParameterOf({.number = node.participant.number}))};
    return std::nullopt;
}

Place StructureModel::placeOf(const Participant &participant) const
{
    return {m_bus != nullptr ? m_bus->id() : firstRing, participant.number};
}

std::optional<Place> StructureModel::numberAt(const QModelIndex &index) const
{
    if (const LineBranch::Row *row = lineRow(index))
        return row->number;
    const int node = nodeOf(index);
    return node < 0 ? std::nullopt
                    : std::optional(placeOf(m_nodes[static_cast<std::size_t>(node)].participant));
}

QModelIndex StructureModel::indexOf(Place number) const
{
    if (number.isOnLine())
        return lineRowIndex(number, deviceColumn);
    for (std::size_t node = 0; node < m_nodes.size(); ++node)
        if (placeOf(m_nodes[node].participant) == number)
            return createIndex(rowOf(static_cast<int>(node)), deviceColumn, static_cast<quintptr>(node) + 1);
    return {};
}

int StructureModel::nodeOf(const QModelIndex &index) const
{
    return index.isValid() && index.internalId() < lineId ? static_cast<int>(index.internalId()) - 1 : -1;
}

int StructureModel::rowOf(int node) const
{
    const int parent = m_nodes[static_cast<std::size_t>(node)].parent;
    const std::vector<int> &siblings =
        parent < 0 ? m_remote : m_nodes[static_cast<std::size_t>(parent)].children;
    return static_cast<int>(std::ranges::find(siblings, node) - siblings.begin());
}

const std::vector<int> &StructureModel::childrenOf(const QModelIndex &index) const
{
    const int node = nodeOf(index);
    return node < 0 ? m_remote : m_nodes[static_cast<std::size_t>(node)].children;
}

QModelIndex StructureModel::index(int row, int column, const QModelIndex &parent) const
{
    if (column < 0 || column >= columns || row < 0 || row >= rowCount(parent))
        return {};
    if (!parent.isValid())
        return createIndex(row, column, row == 0 && hasRing() ? masterId : lineId);
    if (parent.internalId() == lineId)
        return lineRowIndex(m_lineRows[static_cast<std::size_t>(row)].number, column);
    return createIndex(row, column,
                       static_cast<quintptr>(childrenOf(parent)[static_cast<std::size_t>(row)]) + 1);
}

QModelIndex StructureModel::parent(const QModelIndex &index) const
{
    if (lineRow(index))
        return lineIndex();
    const int node = nodeOf(index);
    if (node < 0)
        return {};
    const int above = m_nodes[static_cast<std::size_t>(node)].parent;
    return above < 0 ? createIndex(0, deviceColumn, masterId)
                     : createIndex(rowOf(above), deviceColumn, static_cast<quintptr>(above) + 1);
}

int StructureModel::rowCount(const QModelIndex &parent) const
{
    if (parent.column() > 0 || lineRow(parent))
        return 0;
    if (!parent.isValid())
        return (hasRing() ? 1 : 0) + (m_line.line() ? 1 : 0);
    return static_cast<int>(isLine(parent) ? m_lineRows.size() : childrenOf(parent).size());
}

int StructureModel::columnCount(const QModelIndex &) const
{
    return columns;
}

QVariant StructureModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
        return {};
    switch (section) {
    case deviceColumn:
        return tr("Device");
    case stateColumn:
        return tr("State");
    case positionColumn:
        return tr("Position");
    case profileColumn:
        return tr("Profile");
    case idCodeColumn:
        return tr("ID code");
    case wordsColumn:
        return tr("Words IN / OUT");
    default:
        return {};
    }
}

QVariant StructureModel::data(const QModelIndex &index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    if (role == Qt::TextAlignmentRole)
        return index.column() == positionColumn ? QVariant(Qt::AlignRight | Qt::AlignVCenter) : QVariant();
    if (isLine(index))
        return lineCell(index.column(), role);
    if (const LineBranch::Row *row = lineRow(index))
        return lineEncoderCell(*row, index.column(), role);
    const int node = nodeOf(index);
    return node < 0 ? masterCell(index.column(), role)
                    : deviceCell(m_nodes[static_cast<std::size_t>(node)], index.column(), role);
}

QVariant StructureModel::masterCell(int column, int role) const
{
    if (column == deviceColumn) {
        if (role == Qt::DisplayRole)
            return tr("Master");
        if (role == Qt::DecorationRole)
            return lineIcon(Icon::master);
    }
    if (column == stateColumn) {
        if (role == Qt::DisplayRole)
            return m_master.word;
        if (role == Qt::DecorationRole)
            return lineIcon(roleIcon(m_master.role), m_master.role);
    }
    if (role == Qt::ToolTipRole)
        return tr("The master of the ring is in the state %1.").arg(m_master.word);
    return {};
}

QVariant StructureModel::deviceCell(const Node &node, int column, int role) const
{
    if (role == Qt::ToolTipRole)
        return toolTip(node);
    if (column == positionColumn && node.isOld)
        if (QVariant look = oldPositionLook(node.position, role); look.isValid())
            return look;
    if (role == Qt::DecorationRole) {
        if (column == deviceColumn)
            return lineIcon(node.participant.idCode == busTerminalIdCode ? Icon::ring : Icon::encoder);
        if (column == stateColumn)
            return lineIcon(roleIcon(node.shown.role), node.shown.role);
        return {};
    }
    if (role != Qt::DisplayRole)
        return {};
    switch (column) {
    case deviceColumn:
        return QStringLiteral("%1  %2").arg(node.participant.number.toString(),
                                            calledText(node.station, node.name));
    case stateColumn:
        return node.shown.word;
    case positionColumn:
        return positionText(node.position);
    case profileColumn:
        return node.profile;
    case idCodeColumn:
        return idCodeText(node.participant.idCode);
    case wordsColumn:
        return QStringLiteral("%1 / %2").arg(node.participant.inWords).arg(node.participant.outWords);
    default:
        return {};
    }
}

std::size_t StructureModel::placeOf(const Node &node) const
{
    return static_cast<std::size_t>(&node - m_nodes.data());
}

// How the position stands in IN, where it is not plain binary.
QString StructureModel::codingText(const Node &node) const
{
    const EncoderSession *encoder = m_bus == nullptr ? nullptr : m_bus->encoder(node.participant.number);
    const auto coding = encoder == nullptr ? std::nullopt : encoder->latest().coding;
    if (coding == PositionCoding::gray)
        return tr("Position: Gray code");
    if (coding == PositionCoding::signedBinary)
        return tr("Position: signed");
    return {};
}

// On the housing, as they have to be.
QString StructureModel::ledsText(const Node &node) const
{
    const std::size_t place = placeOf(node);
    if (m_bus == nullptr || place >= m_bus->latest().devices.size() ||
        !hasRemoteBusLeds(m_bus->encoder(node.participant.number)))
        return {};
    const Snapshot &ring = m_bus->latest();
    return tr("LEDs: %1").arg(ledText(ledsOf(ring.state, ring.devices[place].inRing)));
}

QString StructureModel::toolTip(const Node &node) const
{
    const EncoderSession *encoder = m_bus == nullptr ? nullptr : m_bus->encoder(node.participant.number);
    QStringList more{ledsText(node), codingText(node),
                     encoder == nullptr ? QString() : ageSentence(*encoder)};
    more.removeAll(QString());
    const QString text =
        tr("%1  %2\nID code %3, device code %4\nWords: IN %5, OUT %6\nState: %7")
            .arg(node.participant.number.toString(), calledText(node.station, node.name),
                 idCodeText(node.participant.idCode), hexCode(node.participant.deviceCode, 4))
            .arg(node.participant.inWords)
            .arg(node.participant.outWords)
            .arg(node.shown.word);
    return (QStringList{text} + more).join(u'\n');
}

} // namespace codewheel
