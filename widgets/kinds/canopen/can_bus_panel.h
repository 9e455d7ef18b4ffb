// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/protocol/nmt.h"
#include "widgets/look/scrolled_panel.h"

#include <QPointer>

#include <optional>
#include <vector>

class QLabel;
class QPushButton;
class QTableView;

namespace codewheel {

class CanNodeModel;
class CanopenSession;
struct CanopenFact;
class RoleLabel;

// The CAN bus at a glance: its nodes with what they tell of themselves, load, the state of the controller,
// counters. The chosen node can be sent to another NMT state, and be given another number, which whoever
// shows the panel carries out.
class CanBusPanel : public ScrolledPanel
{
    Q_OBJECT

public:
    explicit CanBusPanel(QWidget *parent = nullptr);
    ~CanBusPanel() override;

    void setBus(codewheel::CanopenSession *bus); // null: none
    void chooseNode(int node);                   // if it is listed
    std::optional<int> chosenNode() const;

Q_SIGNALS:
    void commandWanted(int node, codewheel::canopen::NmtCommand command);
    void setupWanted(int node); // its number and rate
    void searchWanted();        // for a device without a number

private:
    QWidget *makeButtons();
    void makeTable();
    void showState();
    void showNodes();
    void showFigures();
    void showWhatIsPossible();
    QString whyNoCommand() const; // empty: one can be sent

    QPointer<CanopenSession> m_bus;
    RoleLabel *m_state;
    CanNodeModel *m_nodes;
    QTableView *m_table;
    std::vector<QPushButton *> m_commands; // as in the list of commands
    QPushButton *m_setup = nullptr;
    QPushButton *m_find = nullptr;
    std::vector<std::pair<const CanopenFact *, QLabel *>> m_facts;
};

} // namespace codewheel
