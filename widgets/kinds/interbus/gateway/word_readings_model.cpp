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

// Null: the column has none.
const WordReading *readingAt(const DeviceRegisters &device, int column)
{
    if (column < WordReadingsModel::firstOrder)
        return nullptr;
    const auto order = static_cast<WordOrder>(column - WordReadingsModel::firstOrder);
    const auto found = std::ranges::find(device.readings, order, &WordReading::order);
    return found == device.readings.end() ? nullptr : &*found;
}

QString toolTip(const WordReading *word)
{
    if (word == nullptr)
        return {};
    const QString verdict = plausibilityText(word->plausibility);
    return word->meaning.isEmpty() ? verdict : QStringLiteral("%1: %2").arg(verdict, word->meaning);
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
    const bool orderChanged = std::exchange(m_set, set) != set;
    if (!std::ranges::equal(devices, rows(), {}, &DeviceRegisters::place, &DeviceRegisters::place))
        setRows(std::move(devices));
    else if (orderChanged || devices != rows())
        for (int row = 0; row < rowCount(); ++row)
            replace(row, std::move(devices[static_cast<std::size_t>(row)]));
    if (orderChanged)
        Q_EMIT headerDataChanged(Qt::Horizontal, firstOrder, columns() - 1);
}

std::optional<WordOrder> WordReadingsModel::onlyFitting() const
{
    std::optional<WordOrder> only;
    for (const WordOrder order : {WordOrder::abcd, WordOrder::cdab}) {
        const bool fitsAll =
            !rows().empty() && std::ranges::all_of(rows(), [order](const DeviceRegisters &device) {
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

QString WordReadingsModel::text(const DeviceRegisters &device, int column) const
{
    switch (column) {
    case place:
        return device.place.toString();
    case inRegisters:
        return registerRange(device.in);
    case outRegisters:
        return registerRange(device.out);
    default:
        const WordReading *word = readingAt(device, column);
        if (word == nullptr)
            return QStringLiteral("\u2013");
        return device.in.count == 1 ? hexCode(word->word, 4) : hexWord(word->word);
    }
}

QVariant WordReadingsModel::cell(const DeviceRegisters &device, int column, int role) const
{
    const WordReading *word = readingAt(device, column);
    switch (role) {
    case Qt::ToolTipRole:
        return toolTip(word);
    case Qt::AccessibleTextRole:
        return word == nullptr ? text(device, column)
                               : QStringLiteral("%1, %2").arg(text(device, column), toolTip(word));
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
        return TableModelBase::cell(device, column, role);
    }
}

QVariant WordReadingsModel::headerCell(int column, int role) const
{
    if (role != Qt::DisplayRole && role != Qt::ToolTipRole)
        return {};
    switch (column) {
    case place:
        return tr("Place");
    case inRegisters:
        return role == Qt::ToolTipRole ? tr("Registers of its IN word") : tr("IN");
    case outRegisters:
        return role == Qt::ToolTipRole ? tr("Registers of its OUT word") : tr("OUT");
    default:
        break;
    }
    const auto order = static_cast<WordOrder>(column - firstOrder);
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
