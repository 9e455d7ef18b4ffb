// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/eds/compare_files.h"
#include "kinds/canopen/protocol/sdo_client.h"
#include "widgets/models/table_model_base.h"

#include <QTime>

namespace codewheel {

// An object of a node, and what the node has answered for it.
struct ObjectRow
{
    canopen::FileObject object{};
    std::optional<canopen::FileValue> now{};
    QString refused{};                                     // why the node gave no value
    QTime at{};                                            // of the answer
    std::optional<canopen::ObjectDifference> difference{}; // to the file compared with

    bool differsFromDefault(std::optional<int> node) const;
};

// The objects of a node, by index and subindex.
class ObjectModel final : public TableModelBase<ObjectRow>
{
    Q_OBJECT

public:
    explicit ObjectModel(QObject *parent = nullptr);

    enum Column : int { object, name, type, access, factory, value, meaning, other, readAt, columnCountAll };

    // `rows`: those taken before, with their values. The number of the node counts for defaults.
    void show(std::vector<ObjectRow> rows, std::optional<int> node);
    void take(canopen::SdoObject object, const canopen::SdoOutcome &outcome, QTime at);
    // Each object that differs has the other value beside its own.
    void setDifferences(const std::vector<canopen::ObjectDifference> &differences);
    int rowOf(canopen::SdoObject object) const; // -1: none

    // The rows of a file of which nothing is read yet.
    static std::vector<ObjectRow> rowsOf(const canopen::DeviceFile &file);

protected:
    int columns() const override { return columnCountAll; }
    QVariant headerCell(int column, int role) const override;
    QVariant cell(const ObjectRow &row, int column, int role) const override;

private:
    QString textOf(const ObjectRow &row, int column) const;
    QString tipOf(const ObjectRow &row, int column) const;

    std::optional<int> m_node;
};

} // namespace codewheel
