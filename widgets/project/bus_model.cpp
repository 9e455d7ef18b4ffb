// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/project/bus_model.h"

#include "project/bus_kind.h"
#include "widgets/project/project_document.h"

#include <QLocale>

#include <algorithm>

namespace codewheel {
namespace {} // namespace

BusModel::BusModel(ProjectDocument &document, QObject *parent)
    : TableModelBase(parent)
    , m_document(document)
{
    setRows(planned());
    connect(&m_document, &ProjectDocument::replaced, this, [this] { setRows(planned()); });
    connect(&m_document, &ProjectDocument::changed, this, &BusModel::followProject);
}

std::vector<BusRow> BusModel::planned() const
{
    const Project &project = m_document.project();
    std::vector<BusRow> rows;
    for (const PlannedBus &bus : project.buses) {
        const BusKind *its = busKind(bus.kind);
        rows.push_back({.bus = bus.id,
                        .name = bus.name,
                        .kind = its != nullptr ? its->title() : bus.kind,
                        .link = its != nullptr ? its->linkText(bus.settings) : QString(),
                        .devices = static_cast<int>(devicesOn(project, bus.id).size())});
    }
    return rows;
}

void BusModel::followProject()
{
    const std::vector<BusRow> now = planned();
    for (int row = rowCount(); row-- > 0;)
        if (std::ranges::find(now, rowAt(row).bus, &BusRow::bus) == now.end())
            removeAt(row);
    for (int row = 0; row < std::ssize(now); ++row) {
        const BusRow &its = now[static_cast<std::size_t>(row)];
        if (row >= rowCount() || rowAt(row).bus != its.bus)
            insertAt(row, its);
        else if (rowAt(row) != its)
            replace(row, its);
    }
}

std::optional<int> BusModel::rowOf(BusId bus) const
{
    const auto found = std::ranges::find(rows(), bus, &BusRow::bus);
    return found == rows().end() ? std::nullopt : std::optional(static_cast<int>(found - rows().begin()));
}

// Bus names appear in BUS/PLACE, which identifies a device.
QString BusModel::complaint(const QModelIndex &index, const QString &text) const
{
    const QString wanted = text.trimmed();
    if (wanted == rowAt(index.row()).name)
        return {};
    if (wanted.isEmpty())
        return tr("A bus needs a name: type one. Esc gives back the previous name.");
    if (wanted.contains(u'/'))
        return tr("The name of a bus has no \"/\", which separates it from the place of a device.");
    if (std::ranges::find(rows(), wanted, &BusRow::name) != rows().end())
        return tr("Another bus is called \"%1\": a name can be used only once in a project.").arg(wanted);
    return {};
}

Qt::ItemFlags BusModel::flags(const QModelIndex &index) const
{
    const Qt::ItemFlags usual = TableModelBase::flags(index);
    return index.isValid() && index.column() == name ? usual | Qt::ItemIsEditable : usual;
}

bool BusModel::setData(const QModelIndex &index, const QVariant &value, int role)
{
    if (role != Qt::EditRole || !checkIndex(index, CheckIndexOption::IndexIsValid) ||
        index.column() != name || !complaint(index, value.toString()).isEmpty())
        return false;
    const BusRow row = rowAt(index.row());
    Project after = m_document.project();
    findBus(after, row.bus)->name = value.toString().trimmed();
    m_document.edit(std::move(after), tr("Rename %1").arg(row.name));
    return true;
}

std::span<const ColumnHead> BusModel::heads() const
{
    static constexpr ColumnHead all[] = {{QT_TR_NOOP("Name"), Qt::AlignLeft},
                                         {QT_TR_NOOP("Kind"), Qt::AlignLeft},
                                         {QT_TR_NOOP("Link"), Qt::AlignLeft},
                                         {QT_TR_NOOP("Devices"), Qt::AlignRight}};
    return all;
}

QVariant BusModel::cell(const BusRow &row, int column, int role) const
{
    if (role == Qt::TextAlignmentRole)
        return headerCell(column, role);
    if (role == Qt::ToolTipRole)
        return column == name ? tr("%1: F2 or a double click renames it").arg(row.name) : QVariant();
    if (role != Qt::DisplayRole && role != Qt::EditRole)
        return {};
    return QStringList{row.name, row.kind, row.link, QLocale().toString(row.devices)}.at(column);
}

} // namespace codewheel
