// SPDX-License-Identifier: GPL-3.0-or-later
// The content of the cells, their input, and dragging devices within the tree.
#include "widgets/look/roles.h"
#include "widgets/structure_editor/plan_model.h"

#include <QCoreApplication>
#include <QIODevice>
#include <QMimeData>

#include <algorithm>

namespace codewheel {
namespace {

Role worst(const std::vector<Finding> &findings)
{
    const bool isFault = std::ranges::any_of(
        findings, [](const Finding &finding) { return finding.severity == Severity::fault; });
    return isFault ? Role::fault : Role::attention;
}

QString joined(const std::vector<Finding> &findings, const QString &between)
{
    QStringList texts;
    for (const Finding &finding : findings)
        texts << finding.text;
    return texts.join(between);
}

// Ids are meaningless to other programs.
QString deviceFormat()
{
    return QStringLiteral("application/x-codewheel-devices-%1").arg(QCoreApplication::applicationPid());
}

} // namespace

QVariant PlanModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    const bool isTitle = orientation == Qt::Horizontal && role == Qt::DisplayRole && section < columnCount();
    return isTitle ? columnAt(section).title : QVariant();
}

QVariant PlanModel::data(const QModelIndex &index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const PlanRow &row = nodeAt(index)->shown;
    const PlanColumn &column = columnAt(index.column());
    switch (role) {
    case Qt::DisplayRole:
        return display(row, column);
    case Qt::EditRole:
        return column.field == PlanField::own ? row.own[column.own].typed.value_or(QString())
                                              : display(row, column);
    case Qt::DecorationRole:
        return decoration(row, column);
    case Qt::ToolTipRole:
        return toolTip(row, column);
    case Qt::TextAlignmentRole:
        return column.isNumber ? QVariant(Qt::AlignRight | Qt::AlignVCenter) : QVariant();
    default:
        return {};
    }
}

QString PlanModel::display(const PlanRow &row, const PlanColumn &column) const
{
    switch (column.field) {
    case PlanField::place:
        return row.place.toString();
    case PlanField::station:
        return row.station;
    case PlanField::group:
        return row.group;
    case PlanField::device:
        return row.name;
    case PlanField::own:
        return row.own[column.own].text;
    case PlanField::serialNumber:
        return row.serialNumber;
    case PlanField::note:
        return row.note;
    case PlanField::findings:
        break;
    }
    return joined(row.findings, QStringLiteral(" "));
}

QVariant PlanModel::decoration(const PlanRow &row, const PlanColumn &column)
{
    const bool isPlace = column.field == PlanField::place;
    // A finding should be seen even before its column is scrolled into view.
    if (!row.findings.empty() && (isPlace || column.field == PlanField::findings))
        return lineIcon(roleIcon(worst(row.findings)), worst(row.findings));
    return isPlace ? lineIcon(row.isCoupler ? Icon::ring : Icon::encoder) : QVariant();
}

QString PlanModel::toolTip(const PlanRow &row, const PlanColumn &column)
{
    if (column.field == PlanField::findings)
        return joined(row.findings, QStringLiteral("\n"));
    if (column.field == PlanField::own && !row.own[column.own].toolTip.isEmpty())
        return row.own[column.own].toolTip;
    return row.findings.empty() ? row.toolTip
                                : row.toolTip + u'\n' + joined(row.findings, QStringLiteral("\n"));
}

QString PlanModel::complaint(const QModelIndex &index, const QString &text) const
{
    return m_edits.rules().complaint(m_edits.project(), nodeAt(index)->shown.place, columnAt(index.column()),
                                     text.trimmed());
}

bool PlanModel::setData(const QModelIndex &index, const QVariant &value, int role)
{
    const auto id = idAt(index);
    if (!id || role != Qt::EditRole || !(flags(index) & Qt::ItemIsEditable))
        return false;
    const QString text = value.toString().trimmed();
    if (const QString wrong = complaint(index, text); !wrong.isEmpty()) {
        Q_EMIT badInput(wrong);
        return false;
    }
    return m_edits.type(*id, columnAt(index.column()), text).has_value();
}

Qt::ItemFlags PlanModel::flags(const QModelIndex &index) const
{
    const bool isOrdered = m_edits.rules().isOrdered();
    if (!index.isValid())
        return isOrdered ? Qt::ItemIsDropEnabled : Qt::NoItemFlags;
    const PlanRow &row = nodeAt(index)->shown;
    Qt::ItemFlags flags = Qt::ItemIsSelectable | Qt::ItemIsEnabled;
    flags.setFlag(Qt::ItemIsDragEnabled, isOrdered);
    flags.setFlag(Qt::ItemIsDropEnabled, row.isCoupler);
    flags.setFlag(Qt::ItemIsEditable, m_edits.rules().isEditable(row, columnAt(index.column())));
    return flags;
}

QStringList PlanModel::mimeTypes() const
{
    return {deviceFormat()};
}

QMimeData *PlanModel::mimeData(const QModelIndexList &indexes) const
{
    QByteArray bytes;
    QDataStream stream(&bytes, QIODevice::WriteOnly);
    for (const QModelIndex &index : indexes)
        if (const auto id = idAt(index); id && index.column() == 0)
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
    if (const auto moved = m_edits.drop(ids, idAt(parent), row); !moved)
        Q_EMIT refused(moved.error());
    return false;
}

} // namespace codewheel
