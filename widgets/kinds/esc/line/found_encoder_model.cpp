// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/esc/line/found_encoder_model.h"

#include "vocabulary/hex.h"
#include "vocabulary/serial_number_text.h"
#include "widgets/look/fonts.h"

namespace codewheel {
namespace {

constexpr int deviceCodeDigits = 4;

} // namespace

void FoundEncoderModel::show(const std::vector<FoundEncoder> &found)
{
    const std::size_t before = rows().size();
    for (std::size_t i = 0; i < std::min(before, found.size()); ++i)
        if (rows()[i] != found[i])
            replace(static_cast<int>(i), found[i]);
    if (found.size() > before)
        append({found.begin() + static_cast<std::ptrdiff_t>(before), found.end()});
    if (found.size() != before)
        Q_EMIT chosenChanged();
}

void FoundEncoderModel::clear()
{
    m_left.clear();
    setRows({});
    Q_EMIT chosenChanged();
}

std::vector<FoundEncoder> FoundEncoderModel::chosen() const
{
    std::vector<FoundEncoder> chosen;
    for (const FoundEncoder &found : rows())
        if (canBeTaken(found) && !m_left.contains(keyOf(found)))
            chosen.push_back(found);
    return chosen;
}

// Every encoder answers at the master address: one found there can be used there as long as it is alone.
bool FoundEncoderModel::canBeTaken(const FoundEncoder &row) const
{
    return row.address.isDevice() || rowCount() == 1;
}

Qt::ItemFlags FoundEncoderModel::flags(const QModelIndex &index) const
{
    const Qt::ItemFlags usual = TableModelBase::flags(index);
    const bool isOffered = index.isValid() && canBeTaken(rowAt(index.row()));
    return index.column() == address && isOffered ? usual | Qt::ItemIsUserCheckable : usual;
}

bool FoundEncoderModel::setData(const QModelIndex &index, const QVariant &value, int role)
{
    if (!index.isValid() || index.column() != address || role != Qt::CheckStateRole ||
        !(flags(index) & Qt::ItemIsUserCheckable))
        return false;
    const Key key = keyOf(rowAt(index.row()));
    if (value.toInt() == Qt::Checked)
        m_left.erase(key);
    else
        m_left.insert(key);
    Q_EMIT dataChanged(index, index, {Qt::CheckStateRole});
    Q_EMIT chosenChanged();
    return true;
}

QString FoundEncoderModel::text(const FoundEncoder &row, int column) const
{
    const QString unknown = QStringLiteral("\u2013");
    switch (column) {
    case address:
        return row.address.isMaster() ? tr("unknown, answers to 00") : row.address.shown();
    case baudRate:
        return QString::number(row.baudRate);
    case serialNumber:
        return row.serialNumber ? serialNumberText(*row.serialNumber) : unknown;
    case deviceCode:
        return row.deviceCode ? hexWord(*row.deviceCode).right(deviceCodeDigits) + u'h' : unknown;
    default:
        return row.version.isEmpty() ? unknown : row.version;
    }
}

std::span<const ColumnHead> FoundEncoderModel::heads() const
{
    static constexpr ColumnHead all[] = {{QT_TR_NOOP("Address"), Qt::AlignLeft},
                                         {QT_TR_NOOP("Baud rate"), Qt::AlignRight},
                                         {QT_TR_NOOP("Serial number"), Qt::AlignLeft},
                                         {QT_TR_NOOP("Device code"), Qt::AlignLeft},
                                         {QT_TR_NOOP("Version"), Qt::AlignLeft}};
    return all;
}

QVariant FoundEncoderModel::cell(const FoundEncoder &row, int column, int role) const
{
    if (role == Qt::CheckStateRole && column == address && canBeTaken(row))
        return m_left.contains(keyOf(row)) ? Qt::Unchecked : Qt::Checked;
    return TableModelBase::cell(row, column, role);
}

} // namespace codewheel
