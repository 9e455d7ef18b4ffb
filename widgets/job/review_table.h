// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/place.h"
#include "widgets/look/fonts.h"
#include "widgets/models/table_model_base.h"

#include <QStringList>

namespace codewheel {

struct ReviewColumn
{
    enum class Kind : std::uint8_t { text, value, number, code }; // code: a word or a request

    QString title;
    Kind kind = Kind::text;
};

struct ReviewRow
{
    enum class Kind : std::uint8_t { head, value, note }; // head: of an encoder, if there are several

    QStringList cells;
    QStringList tips{}; // instead of the cells' texts; an empty one: the cell's text
    QString tip{};      // instead of all of them
    Kind kind = Kind::value;
    Place place{}; // of the encoder, if there are several
    bool canBeChosen = false;
    bool isThere = false; // already there: left out
    bool isHindered = false;
    bool isOld = false; // what is known of the encoder is of before

    friend bool operator==(const ReviewRow &, const ReviewRow &) = default;
};

// What a job will change or send, row by row: in the reviews of parameters, cams and wizard, and in
// transfers.
class ReviewTable : public TableModelBase<ReviewRow>
{
    Q_OBJECT

public:
    using TableModelBase::TableModelBase;

    void setColumns(std::vector<ReviewColumn> columns, TextSize size = TextSize::normal);
    // Keeps unchanged rows, so that the row under the mouse stays.
    void show(std::vector<ReviewRow> rows);

protected:
    int columns() const override { return static_cast<int>(m_columns.size()); }
    QVariant headerCell(int column, int role) const override;
    QVariant cell(const ReviewRow &row, int column, int role) const override;

private:
    const ReviewColumn &at(int column) const { return m_columns.at(static_cast<std::size_t>(column)); }

    std::vector<ReviewColumn> m_columns;
    TextSize m_size = TextSize::normal;
};

} // namespace codewheel
