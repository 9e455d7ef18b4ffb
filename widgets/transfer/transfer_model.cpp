// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/transfer/transfer_model.h"

#include "widgets/look/icons.h"
#include "widgets/look/roles.h"

#include <QGuiApplication>
#include <QPalette>

#include <algorithm>

namespace codewheel {
namespace {

using LineKind = ReviewRow::Kind;

QVariant iconOf(const ReviewRow &line)
{
    if (line.isHindered)
        return lineIcon(Icon::attention, Role::attention);
    if (line.kind == LineKind::note)
        return lineIcon(Icon::information);
    return line.kind == LineKind::head && line.isThere ? lineIcon(Icon::ok, Role::running) : QVariant();
}

} // namespace

TransferModel::TransferModel(Choice choice, QObject *parent)
    : ReviewTable(parent)
    , m_choice(choice)
{
    setHeads(Heads::write);
}

void TransferModel::setHeads(Heads heads)
{
    using Kind = ReviewColumn::Kind;
    m_heads = heads;
    setColumns({{tr("Place")},
                {tr("Encoder and parameter")},
                {tr("Known"), Kind::value},
                {heads == Heads::store ? tr("In the project") : tr("Wanted"), Kind::value},
                {tr("Sent"), Kind::code},
                {tr("EEPROM"), Kind::value}});
}

void TransferModel::show(std::vector<ReviewRow> lines, Heads heads)
{
    if (m_heads != heads)
        setHeads(heads);
    ReviewTable::show(std::move(lines));
    Q_EMIT chosenChanged();
}

bool TransferModel::isChosen(Place number) const
{
    const auto line = std::ranges::find_if(
        rows(), [number](const ReviewRow &one) { return one.kind == LineKind::head && one.place == number; });
    if (line == rows().end() || !line->canBeChosen)
        return false;
    const auto found = m_chosen.find(number);
    return found == m_chosen.end() || found->second;
}

void TransferModel::choose(Place number, bool chosen)
{
    m_chosen[number] = chosen;
    redraw();
}

void TransferModel::chooseAll(bool chosen)
{
    for (const ReviewRow &line : rows())
        if (line.canBeChosen)
            m_chosen[line.place] = chosen;
    redraw();
}

void TransferModel::redraw()
{
    if (rowCount() > 0)
        Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, columns() - 1));
    Q_EMIT chosenChanged();
}

std::vector<Place> TransferModel::chosen() const
{
    std::vector<Place> numbers;
    for (const ReviewRow &line : rows())
        if (line.kind == LineKind::head && isChosen(line.place))
            numbers.push_back(line.place);
    return numbers;
}

Qt::ItemFlags TransferModel::flags(const QModelIndex &index) const
{
    Qt::ItemFlags flags = ReviewTable::flags(index);
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

QVariant TransferModel::cell(const ReviewRow &line, int column, int role) const
{
    switch (role) {
    case Qt::CheckStateRole:
        if (column != place || m_choice == Choice::fixed || !line.canBeChosen)
            return {};
        return isChosen(line.place) ? Qt::Checked : Qt::Unchecked;
    case Qt::AccessibleTextRole:
        return column == place && line.kind == LineKind::head ? tr("%1 %2").arg(line.place.shown(), line.tip)
                                                              : line.cells.value(column);
    case Qt::ForegroundRole:
        return line.kind == LineKind::value &&
                       ((line.isOld && column == now) || line.isThere || !isChosen(line.place))
                   ? QVariant(QGuiApplication::palette().placeholderText())
                   : QVariant();
    case Qt::DecorationRole:
        return column == what ? iconOf(line) : QVariant();
    default:
        return ReviewTable::cell(line, column, role);
    }
}

} // namespace codewheel
