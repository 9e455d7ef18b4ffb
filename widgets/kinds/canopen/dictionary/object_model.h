// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/protocol/sdo_client.h"
#include "widgets/kinds/canopen/dictionary/object_rows.h"
#include "widgets/models/table_model_base.h"

namespace codewheel {

// The objects of a node, by index and subindex.
class ObjectModel final : public TableModelBase<ObjectRow>
{
    Q_OBJECT

public:
    explicit ObjectModel(QObject *parent = nullptr);

    enum Column : int { object, name, value, meaning, access, type, project, inFile, factory, other, readAt };

    // `rows`: those taken before, with their values. The number of the node counts for defaults.
    void show(std::vector<ObjectRow> rows, std::optional<int> node);
    void take(canopen::SdoObject object, const canopen::SdoOutcome &outcome, QTime at);
    // What it was heard to have since it was read.
    void hear(canopen::SdoObject object, canopen::Octets octets, QTime at);
    // Each object that differs has the other value beside its own.
    void setDifferences(const std::vector<canopen::ObjectDifference> &differences);
    void setWanted(const std::vector<canopen::WantedObject> &wanted); // by the project
    bool isDifferent(const ObjectRow &row) const;     // from its file, the project or the file compared with
    bool isInOneFileOnly(const ObjectRow &row) const; // which is all that differs
    int rowOf(canopen::SdoObject object) const;       // -1: none

protected:
    std::span<const ColumnHead> heads() const override;
    QVariant cell(const ObjectRow &row, int column, int role) const override;

private:
    QString textOf(const ObjectRow &row, int column) const;
    QString meaningOf(const ObjectRow &row) const;
    QString otherOf(const ObjectRow &row) const;
    static QString timeOf(const ObjectRow &row);
    QString tipOf(const ObjectRow &row, int column) const;
    bool isMarked(const ObjectRow &row, int column) const;

    std::optional<int> m_node;
};

} // namespace codewheel
