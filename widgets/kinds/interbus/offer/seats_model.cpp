// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/interbus/offer/seats_model.h"

#include "vocabulary/hex.h"
#include "widgets/kinds/interbus/offer/served_text.h"
#include "widgets/look/fonts.h"
#include "widgets/look/icons.h"
#include "widgets/look/roles.h"

namespace codewheel {
namespace {

QString wordText(std::optional<Word> word)
{
    return word ? hexWord(*word) : QStringLiteral("\u2013");
}

} // namespace

void SeatsModel::show(const std::vector<Seat> &seats)
{
    if (seats.size() != rows().size()) {
        setRows(seats);
        return;
    }
    for (std::size_t i = 0; i < seats.size(); ++i)
        if (rows()[i] != seats[i])
            replace(static_cast<int>(i), seats[i]);
}

std::span<const ColumnHead> SeatsModel::heads() const
{
    static constexpr ColumnHead all[] = {
        {QT_TR_NOOP("Seat"), Qt::AlignRight, QT_TR_NOOP("Its number is the Modbus unit")},
        {QT_TR_NOOP("Clients"), Qt::AlignRight, QT_TR_NOOP("How many clients asked this unit last")},
        {QT_TR_NOOP("Ring"), Qt::AlignLeft, QT_TR_NOOP("State of its ring")},
        {QT_TR_NOOP("Faults"), Qt::AlignLeft,
         QT_TR_NOOP("What the trainer or a fault plan has caused in its ring, and is not over")},
        {QT_TR_NOOP("Written last"), Qt::AlignLeft,
         QT_TR_NOOP(
             "Device, OUT word, and when it was on the bus, whoever wrote it; not what stood there already")},
        {QT_TR_NOOP("IN"), Qt::AlignLeft, QT_TR_NOOP("IN word of the device that is chosen above")},
        {QT_TR_NOOP("OUT"), Qt::AlignLeft, QT_TR_NOOP("OUT word of the device that is chosen above")},
    };
    return all;
}

QString SeatsModel::text(const Seat &seat, int column) const
{
    switch (column) {
    case unit:
        return QString::number(seat.unit);
    case clients:
        return QString::number(seat.clients);
    case ring:
        return seat.state;
    case in:
        return wordText(seat.in);
    case out:
        return wordText(seat.out);
    case faults:
        return seat.faults;
    default:
        return ServedText::written(seat.written);
    }
}

QVariant SeatsModel::cell(const Seat &seat, int column, int role) const
{
    if (role == Qt::DecorationRole && column == ring)
        return lineIcon(roleIcon(seat.role), seat.role);
    return TableModelBase::cell(seat, column, role);
}

} // namespace codewheel
