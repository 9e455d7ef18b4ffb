// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/gateway/served_clients.h"
#include "vocabulary/role.h"
#include "widgets/models/table_model_base.h"

namespace codewheel {

// A seat of a class: the ring that answers to its unit.
struct Seat
{
    int unit = 0;
    int clients = 0; // whose last request was to it
    Role role{};     // of the state of its ring
    QString state;
    std::optional<ServedClient::Written> written{}; // last, by whomever
    // Words of the device that is looked at; empty: it has none, or they are not of now.
    std::optional<Word> in{};
    std::optional<Word> out{};
    QString faults{}; // that a trainer or a fault plan has caused, and that stand

    friend bool operator==(const Seat &, const Seat &) = default;
};

// The seats of a class, by unit.
class SeatsModel : public TableModelBase<Seat>
{
    Q_OBJECT

public:
    enum Column : std::uint8_t { unit, clients, ring, faults, written, in, out };

    using TableModelBase::TableModelBase;

    void show(const std::vector<Seat> &seats);

protected:
    std::span<const ColumnHead> heads() const override;
    QString text(const Seat &seat, int column) const override;
    bool isNumber(int column) const override { return column != ring && column != faults; }
    QVariant cell(const Seat &seat, int column, int role) const override;
};

} // namespace codewheel
