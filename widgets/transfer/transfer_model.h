// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/models/table_model_base.h"
#include "widgets/transfer/transfer_lines.h"

#include <map>

namespace codewheel {

// What differs between encoders and what is wanted of them: place, parameter, now, wanted, sent, EEPROM
// writes. Each encoder has a check box; all that can be chosen are, unless told otherwise.
class TransferModel final : public TableModelBase<TransferLine>
{
    Q_OBJECT

public:
    enum Column { place, what, now, wanted, sent, eeprom };
    enum class Heads { write, store }; // of the columns now and wanted

    enum class Choice { free, fixed }; // fixed: no check boxes

    explicit TransferModel(Choice choice, QObject *parent = nullptr)
        : TableModelBase(parent)
        , m_choice(choice)
    {}

    // Keeps what is there as far as it is the same, and what was chosen.
    void show(std::vector<TransferLine> lines, Heads heads = Heads::write);
    bool isChosen(Place number) const;
    void choose(Place number, bool chosen);
    void chooseAll(bool chosen);
    void forgetChoice() { m_chosen.clear(); }
    std::vector<Place> chosen() const;

    Qt::ItemFlags flags(const QModelIndex &index) const override;
    bool setData(const QModelIndex &index, const QVariant &value, int role) override;

Q_SIGNALS:
    void chosenChanged();

protected:
    int columns() const override { return 6; }
    QVariant headerCell(int column, int role) const override;
    QVariant cell(const TransferLine &line, int column, int role) const override;

private:
    void redraw(int row);

    Choice m_choice;
    Heads m_heads = Heads::write;
    std::map<Place, bool> m_chosen; // where the user chose
};

} // namespace codewheel
