// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/canopen/can_found_model.h"

#include "kinds/canopen/protocol/canopen_address.h"
#include "vocabulary/hex.h"
#include "vocabulary/serial_number_text.h"

namespace codewheel {
namespace {

// A word of its identity (1018h), in the order of the columns.
std::optional<std::uint32_t> identityOf(const CanFoundRow &row, int column)
{
    return row.found.identity.at(static_cast<std::size_t>(column - CanFoundModel::vendor));
}

} // namespace

void CanFoundModel::show(std::vector<CanFoundRow> found)
{
    if (found == rows())
        return;
    setRows(std::move(found));
    Q_EMIT chosenChanged();
}

bool CanFoundModel::isChosen(const CanFoundRow &row) const
{
    return row.canBeTaken() && !m_left.contains(row.found.node);
}

std::vector<CanFoundRow> CanFoundModel::chosen() const
{
    std::vector<CanFoundRow> chosen;
    std::ranges::copy_if(rows(), std::back_inserter(chosen),
                         [this](const CanFoundRow &row) { return isChosen(row); });
    return chosen;
}

Qt::ItemFlags CanFoundModel::flags(const QModelIndex &index) const
{
    const Qt::ItemFlags usual = TableModelBase::flags(index);
    const bool isOffered = index.isValid() && rowAt(index.row()).canBeTaken();
    return index.column() == node && isOffered ? usual | Qt::ItemIsUserCheckable : usual;
}

bool CanFoundModel::setData(const QModelIndex &index, const QVariant &value, int role)
{
    if (!index.isValid() || role != Qt::CheckStateRole || !(flags(index) & Qt::ItemIsUserCheckable))
        return false;
    const int number = rowAt(index.row()).found.node;
    if (value.toInt() == Qt::Checked)
        m_left.erase(number);
    else
        m_left.insert(number);
    Q_EMIT dataChanged(index, index, {Qt::CheckStateRole});
    Q_EMIT chosenChanged();
    return true;
}

std::span<const ColumnHead> CanFoundModel::heads() const
{
    static constexpr ColumnHead all[] = {
        {QT_TR_NOOP("Node"), Qt::AlignLeft},     {QT_TR_NOOP("Device"), Qt::AlignLeft},
        {QT_TR_NOOP("Vendor"), Qt::AlignLeft},   {QT_TR_NOOP("Product"), Qt::AlignLeft},
        {QT_TR_NOOP("Revision"), Qt::AlignLeft}, {QT_TR_NOOP("Serial number"), Qt::AlignLeft}};
    return all;
}

QString CanFoundModel::text(const CanFoundRow &row, int column) const
{
    if (column == node)
        return CanopenAddress{row.found.node}.shown();
    if (column == device)
        return row.isThere ? tr("%1, on this bus already").arg(row.device) : row.device;
    const auto word = identityOf(row, column);
    if (!word)
        return QStringLiteral("\u2013");
    return column == serialNumber ? serialNumberText(*word) : hexNumber(*word);
}

QVariant CanFoundModel::cell(const CanFoundRow &row, int column, int role) const
{
    if (role == Qt::CheckStateRole && column == node && row.canBeTaken())
        return isChosen(row) ? Qt::Checked : Qt::Unchecked;
    return TableModelBase::cell(row, column, role);
}

} // namespace codewheel
