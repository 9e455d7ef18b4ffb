// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/scrolled_panel.h"

class QLabel;
class QPushButton;
class QTableView;

namespace codewheel {

class LinkFiguresModel;
class RingSession;
struct Snapshot;
class RoleLabel;

// A ring behind a gateway at a glance: where it is, state, what may be written, and the statistics of its
// link. In place of MasterPanel, since no gateway reaches the master.
class GatewayPanel : public ScrolledPanel
{
    Q_OBJECT

public:
    // The bus outlives the panel.
    explicit GatewayPanel(RingSession &bus, QWidget *parent = nullptr);
    ~GatewayPanel() override;

    void setGateway(const QString &gateway); // as known to the user

Q_SIGNALS:
    void connectionWanted(); // its settings
    void registersWanted();

private:
    void makeTable();
    QPushButton *addButton(const QString &text, const QString &toolTip);
    QString stateOf(const Snapshot &ring) const;
    void refresh();

    RingSession &m_bus;
    RoleLabel *m_state;
    QLabel *m_gateway = nullptr;
    QLabel *m_mode = nullptr;
    QLabel *m_status = nullptr;
    LinkFiguresModel *m_figures;
    QTableView *m_table;
};

} // namespace codewheel
