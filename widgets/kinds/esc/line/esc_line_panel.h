// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/scrolled_panel.h"

#include <QPointer>

class QLabel;
class QTableView;

namespace codewheel {

class EscLineFiguresModel;
class EscLineSession;
class RoleLabel;

// The serial line at a glance: port, baud rate, state and statistics, as a whole and encoder by encoder.
class EscLinePanel : public ScrolledPanel
{
    Q_OBJECT

public:
    explicit EscLinePanel(QWidget *parent = nullptr);
    ~EscLinePanel() override;

    void setLine(codewheel::EscLineSession *line); // null: none

private:
    void makeTable();
    void showState();
    void showFigures();

    QPointer<EscLineSession> m_line;
    RoleLabel *m_state;
    QLabel *m_port = nullptr;
    QLabel *m_rate = nullptr;
    QLabel *m_latency = nullptr;
    QLabel *m_polling = nullptr;
    QLabel *m_mode = nullptr;
    EscLineFiguresModel *m_figures;
    QTableView *m_table;
    QLabel *m_dropped;
};

} // namespace codewheel
