// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/job/review_table.h"

#include <map>

namespace codewheel {

// How encoders differ from what is wanted of them: place, parameter, now, wanted, sent, EEPROM writes. Each
// encoder has a check box; all that can be chosen initially are.
class TransferModel final : public ReviewTable
{
    Q_OBJECT

public:
    enum Column { place, what, now, wanted, sent, eeprom };
    enum class Heads { write, store }; // of the columns now and wanted

    enum class Choice { free, fixed }; // fixed: no check boxes

    explicit TransferModel(Choice choice, QObject *parent = nullptr);

    // Keeps the user's choice.
    void show(std::vector<ReviewRow> lines, Heads heads = Heads::write);
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
    QVariant cell(const ReviewRow &line, int column, int role) const override;

private:
    void setHeads(Heads heads);
    void redraw();

    Choice m_choice;
    Heads m_heads = Heads::write;
    std::map<Place, bool> m_chosen; // by the user
};

} // namespace codewheel
