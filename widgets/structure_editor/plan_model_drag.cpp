// SPDX-License-Identifier: GPL-3.0-or-later
// Devices dragged within the tree.
#include "widgets/structure_editor/plan_edits.h"
#include "widgets/structure_editor/plan_model.h"

#include <QCoreApplication>
#include <QIODevice>
#include <QMimeData>

#include <algorithm>

namespace codewheel {
namespace {

// Ids, which mean nothing to another program.
QString deviceFormat()
{
    return QStringLiteral("application/x-codewheel-devices-%1").arg(QCoreApplication::applicationPid());
}

} // namespace

QStringList PlanModel::mimeTypes() const
{
    return {deviceFormat()};
}

QMimeData *PlanModel::mimeData(const QModelIndexList &indexes) const
{
    QByteArray bytes;
    QDataStream stream(&bytes, QIODevice::WriteOnly);
    for (const QModelIndex &index : indexes)
        if (const auto id = idAt(index); id && index.column() == numberColumn)
            stream << *id;
    auto *data = new QMimeData;
    data->setData(deviceFormat(), bytes);
    return data;
}

bool PlanModel::dropMimeData(const QMimeData *data, Qt::DropAction action, int row, int,
                             const QModelIndex &parent)
{
    if (action != Qt::MoveAction || !data->hasFormat(deviceFormat()))
        return false;
    QDataStream stream(data->data(deviceFormat()));
    PlanEdits::Ids ids;
    while (!stream.atEnd()) {
        Id id = 0;
        stream >> id;
        if (m_nodes.contains(id))
            ids.push_back(id);
    }
    if (ids.empty())
        return false;
    if (const auto place = dropPlace(m_nodes.at(ids.front())->shown.participant, row, parent))
        if (const auto moved = PlanEdits(m_document, m_catalog).move(ids, *place); !moved)
            Q_EMIT refused(moved.error());
    return false;
}

// Onto a bus terminal: to the end of the bus where it belongs. Between the last of a local bus and the first
// of a branch a device goes where it belongs as well.
std::optional<RingPlace> PlanModel::dropPlace(const Participant &device, int row,
                                              const QModelIndex &parent) const
{
    const Node &above = *nodeAt(parent);
    const auto at = static_cast<std::size_t>(row);
    RingPlace place{.terminal = {}, .onLocalBus = false, .row = row < 0 ? above.children.size() : at};
    if (!parent.isValid())
        return place;
    place.terminal = m_document.indexOf(above.id);
    const bool isLocal = prefersLocalBus(device);
    if (row < 0) {
        place.onLocalBus = isLocal;
        return place;
    }
    place.onLocalBus = at < above.localDevices || (at == above.localDevices && isLocal);
    if (!place.onLocalBus)
        place.row = at - above.localDevices;
    return place;
}

} // namespace codewheel
