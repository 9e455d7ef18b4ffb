// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/bus/canopen_facts.h"
#include "widgets/models/table_model_base.h"

#include <QDateTime>

#include <map>

namespace codewheel {

class CanopenSession;

// A node of a CAN bus: one that was heard, or an encoder of the bus that was not.
struct CanNodeRow
{
    int node = 0;
    QString name; // of its encoder; empty: it is none of the bus's
    bool isHeard = false;
    bool isInTrouble = false;
    bool isWaiting = false; // stopped or pre-operational
    bool isOld = false;     // as before the link was lost
    QString state;          // with heartbeat and PDOs, a line each
    QString errors;         // empty: none
    QString since;          // it is like that; empty: not known

    friend bool operator==(const CanNodeRow &, const CanNodeRow &) = default;
};

// The nodes of a CAN bus, one in each row, with what they tell of themselves.
class CanNodeModel final : public TableModelBase<CanNodeRow>
{
    Q_OBJECT

public:
    explicit CanNodeModel(QObject *parent = nullptr);

    enum Column : int {
        node,  // number, and its name below
        state, // heartbeat and PDOs below, and since when all of this is so
        error,
        columnCountOfIt,
    };

    // Tells the views only what has changed. Null: no bus.
    void show(const CanopenSession *bus);
    int rowOf(int node) const; // -1: none

protected:
    int columns() const override;
    QVariant headerCell(int column, int role) const override;
    QString text(const CanNodeRow &row, int column) const override;
    QVariant cell(const CanNodeRow &row, int column, int role) const override;

private:
    // What a node was like, and since when.
    struct Condition
    {
        QString state;
        QString errors;
        int bootUps = 0;
        QString since;
    };

    CanNodeRow rowFor(const CanopenSession &bus, int number);

    std::map<int, Condition> m_conditions; // by node
};

} // namespace codewheel
