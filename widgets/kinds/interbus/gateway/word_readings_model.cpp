// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/interbus/gateway/word_readings_model.h"

#include "catalog/hex_code.h"
#include "kinds/interbus/gateway/gateway_check_text.h"
#include "vocabulary/hex.h"
#include "vocabulary/sentence.h"
#include "widgets/look/fonts.h"
#include "widgets/look/icons.h"
#include "widgets/look/roles.h"

#include <QFont>

#include <algorithm>

namespace codewheel {
namespace {

Role roleOf(Plausibility plausibility)
{
    switch (plausibility) {
    case Plausibility::fits:
        return Role::running;
    case Plausibility::unlikely:
        return Role::attention;
    case Plausibility::cannotBe:
        return Role::fault;
    case Plausibility::notKnown:
        break;
    }
    return Role::inactive;
}

} // namespace

QString registerRange(const RegisterBlock &block)
{
    if (block.count == 0)
        return QStringLiteral("\u2013");
    if (block.count == 1)
        return QString::number(block.first);
    return QStringLiteral("%1\u2013%2").arg(block.first).arg(block.end() - 1);
}

// A table that is shown live keeps its rows, and with them what is chosen.
void WordReadingsModel::show(std::vector<DeviceRegisters> devices, WordOrder set)
{
    const bool isSameRing =
        std::ranges::equal(devices, m_devices, {}, &DeviceRegisters::place, &DeviceRegisters::place);
    if (isSameRing && devices == m_devices && set == m_set)
        return;
    if (!isSameRing)
        beginResetModel();
    m_devices = std::move(devices);
    const bool orderChanged = std::exchange(m_set, set) != set;
    if (!isSameRing)
        endResetModel();
    else if (rowCount() > 0)
        Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, columns - 1));
    if (orderChanged)
        Q_EMIT headerDataChanged(Qt::Horizontal, firstOrder, columns - 1);
}

std::optional<WordOrder> WordReadingsModel::onlyFitting() const
{
    std::optional<WordOrder> only;
    for (const WordOrder order : {WordOrder::abcd, WordOrder::cdab}) {
        const bool fitsAll =
            !m_devices.empty() && std::ranges::all_of(m_devices, [order](const DeviceRegisters &device) {
                const WordReading *its = readingIn(device.readings, order);
                return its == nullptr || its->plausibility != Plausibility::cannotBe;
            });
        if (fitsAll && only)
            return std::nullopt;
        if (fitsAll)
            only = order;
    }
    return only;
}

int WordReadingsModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_devices.size());
}

int WordReadingsModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : columns;
}

const WordReading *WordReadingsModel::reading(const QModelIndex &index) const
{
    if (index.column() < firstOrder)
        return nullptr;
    const auto order = static_cast<WordOrder>(index.column() - firstOrder);
    const auto &readings = device(index.row()).readings;
    const auto found = std::ranges::find(readings, order, &WordReading::order);
    return found == readings.end() ? nullptr : &*found;
}

QString WordReadingsModel::text(const QModelIndex &index) const
{
    const DeviceRegisters &its = device(index.row());
    switch (index.column()) {
    case place:
        return its.place.toString();
    case inRegisters:
        return registerRange(its.in);
    case outRegisters:
        return registerRange(its.out);
    default:
        const WordReading *word = reading(index);
        if (word == nullptr)
            return QStringLiteral("\u2013");
        return its.in.count == 1 ? hexCode(word->word, 4) : hexWord(word->word);
    }
}

QString WordReadingsModel::toolTip(const QModelIndex &index) const
{
    const WordReading *word = reading(index);
    if (word == nullptr)
        return {};
    const QString verdict = plausibilityText(word->plausibility);
    return word->meaning.isEmpty() ? verdict : QStringLiteral("%1: %2").arg(verdict, word->meaning);
}

QVariant WordReadingsModel::data(const QModelIndex &index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid | CheckIndexOption::ParentIsInvalid))
        return {};
    const WordReading *word = reading(index);
    switch (role) {
    case Qt::DisplayRole:
        return text(index);
    case Qt::ToolTipRole:
        return toolTip(index);
    case Qt::AccessibleTextRole:
        return word == nullptr ? text(index) : QStringLiteral("%1, %2").arg(text(index), toolTip(index));
    case Qt::DecorationRole:
        if (word == nullptr)
            return {};
        return lineIcon(roleIcon(roleOf(word->plausibility)), roleOf(word->plausibility));
    case Qt::FontRole: {
        QFont font = numberFont();
        font.setBold(word != nullptr && word->order == m_set);
        return font;
    }
    default:
        return {};
    }
}

QVariant WordReadingsModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || section < 0 || section >= columns)
        return QAbstractTableModel::headerData(section, orientation, role);
    if (role != Qt::DisplayRole && role != Qt::ToolTipRole)
        return {};
    switch (section) {
    case place:
        return tr("Place");
    case inRegisters:
        return role == Qt::ToolTipRole ? tr("Registers of its IN word") : tr("IN");
    case outRegisters:
        return role == Qt::ToolTipRole ? tr("Registers of its OUT word") : tr("OUT");
    default:
        break;
    }
    const auto order = static_cast<WordOrder>(section - firstOrder);
    if (role == Qt::ToolTipRole)
        return order == WordOrder::abcd   ? tr("High word first")
               : order == WordOrder::cdab ? tr("Low word first")
               : order == WordOrder::badc
                   ? tr("High word first, with the bytes of each register exchanged: the "
                        "gateway has a setting for that")
                   : tr("Low word first, with the bytes of each register exchanged: the "
                        "gateway has a setting for that");
    return order == m_set ? sentence(tr("%1 (set)"), {wordOrderName(order)}) : wordOrderName(order);
}

} // namespace codewheel
