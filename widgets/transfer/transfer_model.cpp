// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/transfer/transfer_model.h"

#include "widgets/look/fonts.h"
#include "widgets/look/icons.h"
#include "widgets/look/roles.h"

#include <QGuiApplication>
#include <QPalette>

#include <algorithm>

namespace codewheel {
namespace {

using LineKind = TransferLine::Kind;

bool isNumber(int column)
{
    return column == TransferModel::now || column == TransferModel::wanted || column == TransferModel::eeprom;
}

QString textOf(const TransferLine &line, int column)
{
    switch (column) {
    case TransferModel::place:
        return line.kind == LineKind::encoder ? line.place.shown() : QString();
    case TransferModel::what:
        return line.what;
    case TransferModel::now:
        return line.now;
    case TransferModel::wanted:
        return line.wanted;
    case TransferModel::sent:
        return line.sent;
    default:
        return line.eeprom;
    }
}

QFont fontOf(const TransferLine &line, int column)
{
    if (column == TransferModel::sent && line.kind == LineKind::value && !line.isThere)
        return numberFont();
    QFont font = textFont();
    font.setBold(line.kind == LineKind::encoder && column <= TransferModel::what);
    return font;
}

QVariant iconOf(const TransferLine &line, int column)
{
    if (column != TransferModel::what || line.kind == LineKind::value)
        return line.isHindered && column == TransferModel::what ? lineIcon(Icon::attention, Role::attention)
                                                                : QVariant();
    if (line.isHindered)
        return lineIcon(Icon::attention, Role::attention);
    if (line.kind == LineKind::note)
        return lineIcon(Icon::information);
    return line.isThere ? QVariant(lineIcon(Icon::ok, Role::running)) : QVariant();
}

} // namespace

void TransferModel::show(std::vector<TransferLine> lines, Heads heads)
{
    if (m_heads != heads) {
        m_heads = heads;
        Q_EMIT headerDataChanged(Qt::Horizontal, 0, columns() - 1);
    }
    const auto isSameLine = [](const TransferLine &a, const TransferLine &b) {
        return a.kind == b.kind && a.place == b.place;
    };
    if (std::ranges::equal(lines, rows(), isSameLine)) {
        for (int row = 0; row < rowCount(); ++row)
            if (auto &line = lines[static_cast<std::size_t>(row)]; rowAt(row) != line)
                replace(row, std::move(line));
    } else {
        setRows(std::move(lines));
    }
    Q_EMIT chosenChanged();
}

bool TransferModel::isChosen(Place number) const
{
    const auto line = std::ranges::find_if(rows(), [number](const TransferLine &one) {
        return one.kind == LineKind::encoder && one.place == number;
    });
    if (line == rows().end() || !line->canBeChosen)
        return false;
    const auto found = m_chosen.find(number);
    return found == m_chosen.end() || found->second;
}

void TransferModel::choose(Place number, bool chosen)
{
    m_chosen[number] = chosen;
    for (int row = 0; row < rowCount(); ++row)
        if (rowAt(row).place == number)
            redraw(row);
    Q_EMIT chosenChanged();
}

void TransferModel::chooseAll(bool chosen)
{
    for (int row = 0; row < rowCount(); ++row)
        if (rowAt(row).canBeChosen) {
            m_chosen[rowAt(row).place] = chosen;
            redraw(row);
        }
    Q_EMIT chosenChanged();
}

void TransferModel::redraw(int row)
{
    Q_EMIT dataChanged(index(row, 0), index(row, columns() - 1));
}

std::vector<Place> TransferModel::chosen() const
{
    std::vector<Place> numbers;
    for (const TransferLine &line : rows())
        if (line.kind == LineKind::encoder && isChosen(line.place))
            numbers.push_back(line.place);
    return numbers;
}

Qt::ItemFlags TransferModel::flags(const QModelIndex &index) const
{
    Qt::ItemFlags flags = TableModelBase::flags(index);
    if (index.isValid() && m_choice == Choice::free && index.column() == place &&
        rowAt(index.row()).canBeChosen)
        flags |= Qt::ItemIsUserCheckable;
    return flags;
}

bool TransferModel::setData(const QModelIndex &index, const QVariant &value, int role)
{
    if (role != Qt::CheckStateRole || !(flags(index) & Qt::ItemIsUserCheckable))
        return false;
    choose(rowAt(index.row()).place, value.toInt() == Qt::Checked);
    return true;
}

QVariant TransferModel::headerCell(int column, int role) const
{
    if (role == Qt::TextAlignmentRole)
        return int((isNumber(column) ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    if (role != Qt::DisplayRole)
        return {};
    switch (column) {
    case place:
        return tr("Place");
    case what:
        return tr("Encoder and parameter");
    case now:
        return tr("Now");
    case wanted:
        return m_heads == Heads::store ? tr("In the project") : tr("Wanted");
    case sent:
        return tr("Sent");
    default:
        return tr("EEPROM");
    }
}

QVariant TransferModel::cell(const TransferLine &line, int column, int role) const
{
    switch (role) {
    case Qt::DisplayRole:
        return textOf(line, column);
    case Qt::CheckStateRole:
        if (column != place || m_choice == Choice::fixed || line.kind != LineKind::encoder ||
            !line.canBeChosen)
            return {};
        return isChosen(line.place) ? Qt::Checked : Qt::Unchecked;
    case Qt::ToolTipRole:
        return line.tip;
    case Qt::AccessibleTextRole:
        return column == place && line.kind == LineKind::encoder
                   ? tr("%1 %2").arg(line.place.shown(), line.tip)
                   : textOf(line, column);
    case Qt::TextAlignmentRole:
        return int((isNumber(column) ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    case Qt::FontRole:
        return fontOf(line, column);
    case Qt::ForegroundRole:
        return line.kind == LineKind::value && (line.isThere || !isChosen(line.place))
                   ? QVariant(QGuiApplication::palette().placeholderText())
                   : QVariant();
    case Qt::DecorationRole:
        return iconOf(line, column);
    default:
        return {};
    }
}

} // namespace codewheel
