// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/interbus/offer/served_registers_model.h"

#include "widgets/kinds/interbus/gateway/word_readings_model.h"
#include "widgets/look/fonts.h"

namespace codewheel {
void ServedRegistersModel::show(std::vector<ServedDevice> devices)
{
    if (devices != rows())
        setRows(std::move(devices));
}

std::span<const ColumnHead> ServedRegistersModel::heads() const
{
    static constexpr ColumnHead all[] = {
        {QT_TR_NOOP("Place"), {}, QT_TR_NOOP("Number of the device in the ring")},
        {QT_TR_NOOP("IN, input"),
         {},
         QT_TR_NOOP("Input registers of its IN word, counted from 0, high word first (function 4)")},
        {QT_TR_NOOP("IN, holding"),
         {},
         QT_TR_NOOP("Holding registers that show its IN word too (functions 3 and 23)")},
        {QT_TR_NOOP("OUT, holding"),
         {},
         QT_TR_NOOP("Holding registers of its OUT word (functions 3, 6, 16, 22, 23)")},
        {QT_TR_NOOP("Device"), {}, QT_TR_NOOP("What it is")},
    };
    return all;
}

QString ServedRegistersModel::text(const ServedDevice &device, int column) const
{
    switch (column) {
    case place:
        return device.registers.place.toString();
    case in:
        return registerRange(device.registers.in);
    case inHolding:
        return registerRange(device.registers.inHolding);
    case out:
        return registerRange(device.registers.out);
    default:
        return device.name;
    }
}

} // namespace codewheel
