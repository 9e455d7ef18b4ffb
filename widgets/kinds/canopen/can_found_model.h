// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/protocol/node_scan.h"
#include "widgets/models/table_model_base.h"

#include <set>

namespace codewheel {

// A node that has answered a search.
struct CanFoundRow
{
    canopen::FoundNode found;
    QString device;       // what it is taken for
    QString deviceKey;    // in the catalog; empty: it is no encoder, by its device type
    bool isThere = false; // an encoder of the bus already

    bool canBeTaken() const { return !deviceKey.isEmpty() && !isThere; }
    friend bool operator==(const CanFoundRow &, const CanFoundRow &) = default;
};

// The nodes that a search of a CAN bus has found; those that are ticked are to be taken over.
class CanFoundModel final : public TableModelBase<CanFoundRow>
{
    Q_OBJECT

public:
    using TableModelBase::TableModelBase;

    enum Column : int { node, device, vendor, product, revision, serialNumber };

    void show(std::vector<CanFoundRow> found); // ticks stay
    std::vector<CanFoundRow> chosen() const;

    Qt::ItemFlags flags(const QModelIndex &index) const override;
    bool setData(const QModelIndex &index, const QVariant &value, int role) override;

Q_SIGNALS:
    void chosenChanged();

protected:
    std::span<const ColumnHead> heads() const override;
    QString text(const CanFoundRow &row, int column) const override;
    QVariant cell(const CanFoundRow &row, int column, int role) const override;

private:
    bool isChosen(const CanFoundRow &row) const;

    std::set<int> m_left; // nodes whose tick was taken away
};

} // namespace codewheel
