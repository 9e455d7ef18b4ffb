// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/bus/canopen_facts.h"
#include "vocabulary/instant.h"
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
    std::vector<QString> facts; // as in canopenNodeFacts()
    QString since;              // its state, heartbeat and error are like that; empty: not known

    friend bool operator==(const CanNodeRow &, const CanNodeRow &) = default;
};

// The nodes of a CAN bus, one in each row, with what they tell of themselves.
class CanNodeModel final : public TableModelBase<CanNodeRow>
{
    Q_OBJECT

public:
    explicit CanNodeModel(QObject *parent = nullptr);

    // Name and since stand beside the facts of canopenNodeFacts().
    enum Column : int { node, name, firstFact };

    // Tells the views only what has changed. Null: no bus.
    void show(const CanopenSession *bus);
    int rowOf(int node) const; // -1: none

protected:
    int columns() const override;
    QVariant headerCell(int column, int role) const override;
    QVariant cell(const CanNodeRow &row, int column, int role) const override;

private:
    // What a node was like, and since when.
    struct Condition
    {
        std::vector<QString> facts;
        QString since;
    };

    int sinceColumn() const { return columns() - 1; }
    QString textOf(const CanNodeRow &row, int column) const;
    CanNodeRow rowFor(const CanopenSession &bus, int number);

    std::map<int, Condition> m_conditions; // by node
};

} // namespace codewheel
