// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/cams/cam_sheet.h"
#include "widgets/models/table_model_base.h"

namespace codewheel {

struct CamRow
{
    std::size_t number = 0;
    Cam cam;
    std::optional<bool> isOn;
    bool mayBeEither = false; // the position is known too coarsely
    bool isTold = false;      // isOn: by the encoder itself
    std::optional<Cam> known; // what the encoder has
    bool isOld = false;       // ... or had: nobody hears from it now

    friend bool operator==(const CamRow &, const CamRow &) = default;
};

// The cams of a sheet as a table: which are active, their start and stop, their state now, and what the
// encoder has. Changing a cell changes the document.
class CamTableModel final : public TableModelBase<CamRow>
{
    Q_OBJECT

public:
    // Hysteresis and polarity are hidden where the encoder has none.
    enum Column {
        camColumn,
        startColumn,
        stopColumn,
        hysteresisColumn,
        polarityColumn,
        stateColumn,
        encoderColumn
    };
    static bool isPosition(int column) { return column >= startColumn && column <= hysteresisColumn; }

    explicit CamTableModel(CamSheet &sheet, QObject *parent = nullptr);

    Qt::ItemFlags flags(const QModelIndex &index) const override;
    // Positions as qlonglong; active and polarity are check boxes. Where the positions do not form a circle,
    // a start above the stop moves the stop along, and vice versa.
    bool setData(const QModelIndex &index, const QVariant &value, int role) override;

protected:
    std::span<const ColumnHead> heads() const override;
    QString text(const CamRow &row, int column) const override;
    QVariant cell(const CamRow &row, int column, int role) const override;

private:
    CamRow rowOf(std::size_t cam) const;
    void refresh();
    void setPosition(Cam &cam, int column, std::int64_t position) const;
    static bool isOld(const CamRow &row, int column);
    QVariant icon(const CamRow &row, int column) const;

    CamSheet &m_sheet;
};

} // namespace codewheel
