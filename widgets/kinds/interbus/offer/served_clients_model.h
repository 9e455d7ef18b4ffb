// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/gateway/served_clients.h"
#include "widgets/models/table_model_base.h"

namespace codewheel {

// The programs that use an offered ring now, in the order in which they came: what each of them has done, and
// what it wrote last.
class ServedClientsModel : public TableModelBase<ServedClient>
{
    Q_OBJECT

public:
    enum Column : std::uint8_t { address, unit, written, requests, writes, refused, since };

    using TableModelBase::TableModelBase;

    // A client keeps its row for as long as it is there.
    void show(const std::vector<ServedClient> &clients);

protected:
    std::span<const ColumnHead> heads() const override;
    QString text(const ServedClient &client, int column) const override;
    bool isNumber(int /*column*/) const override { return true; }
};

} // namespace codewheel
