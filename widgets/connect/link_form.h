// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/kind_data.h"
#include "widgets/connect/port_row.h"
#include "widgets/look/trouble.h"

#include <QWidget>

#include <optional>
#include <vector>

namespace codewheel {

// One kind of link in ConnectPage: what it is called, its settings, and its part of a plan, whose meaning
// only the kind of bus knows. Most forms are never seen, so their fields are made late: what a form is given
// before is kept for them, and it answers as if they showed it.
class LinkForm : public QWidget
{
    Q_OBJECT

public:
    using QWidget::QWidget;

    virtual QString title() const = 0;    // in the list of links: "Modbus/TCP gateway"
    virtual QString sentence() const = 0; // what it is, and what connecting does
    virtual bool canBeTested() const { return false; }
    virtual bool canBeKept() const { return true; } // in a project

    // Once; those of the chosen form are made by ConnectPage.
    void makeFields();
    bool hasFields() const { return m_hasFields; }

    // Whether the plan is of this kind of link; shows it then.
    virtual bool showPlan(const KindData &plan) = 0;
    // What is entered. Fields must have been taken.
    virtual KindData plan() const = 0;
    // What is wrong, so that it cannot even be planned; a sentence, empty: nothing.
    virtual QString wrong() const { return {}; }
    // What is missing for connecting; a sentence, empty: nothing.
    virtual QString complaint() const { return {}; }
    // `trouble`: a sentence shown with the list, such as about missing rights; empty: none. The choice stays,
    // even if it is not in the list.
    void setPorts(const std::vector<PortRow> &ports, const Trouble &trouble = {});

Q_SIGNALS:
    void edited();
    void portsWanted(); // the list, anew
    void fieldsMade();

private:
    struct Ports
    {
        std::vector<PortRow> rows;
        Trouble trouble;
    };

    virtual void addFields() {} // with what was given so far
    virtual void showPorts(const std::vector<PortRow> &, const Trouble & /*trouble*/) {}

    bool m_hasFields = false;
    std::optional<Ports> m_ports; // for the fields
};

} // namespace codewheel
