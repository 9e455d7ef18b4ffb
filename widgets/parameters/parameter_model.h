// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "widgets/models/shown_encoder.h"
#include "widgets/models/table_model_base.h"
#include "widgets/parameters/wanted_values.h"

namespace codewheel {

// What an encoder is known to have for one parameter, and what the user wants it to have; or the heading of a
// group of rows.
struct ParameterRow
{
    enum class Head { none, readOnly, registersClosed, registersOpen };

    ParameterDescription parameter;
    std::optional<Known> known;
    std::optional<Value> wanted;
    Head head = Head::none;

    bool isHead() const { return head != Head::none; }
    bool isReadOnly() const { return !parameter.canBeWritten; }
    // Known from the label only: what is entered is what is known.
    bool isTold() const { return parameter.onLabel; }
    // Both are given, and they are not the same.
    bool differs() const { return known && wanted && known->value != *wanted; }

    friend bool operator==(const ParameterRow &, const ParameterRow &) = default;
};

// The table of the parameter panel: parameter, what the encoder has, what is wanted. Writable parameters come
// first, then the read-only ones; the registers of the bus chip are folded away at the end. A cell may have a
// second, small line (detailRole): how and when the value came to be known, whether it differs. Of an encoder
// that is only planned, nothing is known; wanted values can still be edited.
class ParameterModel final : public TableModelBase<ParameterRow>
{
    Q_OBJECT

public:
    enum Column { nameColumn, knownColumn, wantedColumn };
    static constexpr int detailRole = Qt::UserRole + 1;      // QString
    static constexpr int detailMarkRole = Qt::UserRole + 2;  // int, a Role: icon before the detail
    static constexpr int isPaleRole = Qt::UserRole + 3;      // bool: stands for "no value"
    static constexpr int shortDetailRole = Qt::UserRole + 4; // QString: if the detail has no room

    explicit ParameterModel(WantedValues &wanted, QObject *parent = nullptr);

    void setEncoder(const ShownEncoder &encoder);
    int differing() const; // rows
    // That another encoder of the bus has this address; empty for any other value.
    QString whyTaken(const ParameterValue &wanted) const;

    // Whether it is the heading that folds and unfolds the registers.
    bool isFoldable(const QModelIndex &index) const;
    void toggleRegisters();
    bool showsRegisters() const;
    int rowOf(Parameter parameter) const; // -1: none

    Qt::ItemFlags flags(const QModelIndex &index) const override;
    // The wanted value, a qlonglong; an invalid variant leaves the parameter as it is. A value from the label
    // becomes known instead.
    bool setData(const QModelIndex &index, const QVariant &value, int role) override;

protected:
    std::span<const ColumnHead> heads() const override;
    QString text(const ParameterRow &row, int column) const override;
    QVariant cell(const ParameterRow &row, int column, int role) const override;

private:
    ParameterDescription withRange(const ParameterDescription &parameter) const;
    ParameterRow rowFor(const ParameterDescription &parameter) const;
    std::vector<ParameterRow> rowsOf(bool (*belongs)(const ParameterDescription &)) const;
    QVariant headCell(const ParameterRow &row, int column, int role) const;
    void refresh();
    void showAge();
    bool isKnownOfBefore(const ParameterRow &row) const;
    QString detail(const ParameterRow &row, int column) const;
    QString toolTip(const ParameterRow &row, int column) const;

    WantedValues &m_wanted;
    ShownEncoder m_encoder;
};

} // namespace codewheel
