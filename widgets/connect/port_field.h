// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/connect/port_row.h"
#include "widgets/look/trouble.h"

#include <QWidget>

#include <vector>

class QComboBox;
class QFormLayout;
class QLabel;
class QPushButton;

namespace codewheel {

class InlineMessage;

// The serial port in a form: from the list, or by its path, with its adapter below, and what is wrong with
// the ports. Does not find them itself.
class PortField : public QWidget
{
    Q_OBJECT

public:
    explicit PortField(QWidget *parent = nullptr);

    // Adds its row and that of the trouble.
    void addTo(QFormLayout &form, const QString &label);

    // `trouble`: a sentence shown with the list, such as about missing rights; empty: none. The choice stays,
    // even if it is not in the list.
    void setPorts(const std::vector<PortRow> &ports, const Trouble &trouble = {});
    QString port() const; // empty: none is chosen
    // Shown as if never picked.
    void setPort(const QString &port);
    // Whether it was chosen in the list or typed since setPort().
    bool isPicked() const { return m_isPicked; }

Q_SIGNALS:
    void refreshWanted();
    void edited();

private:
    void makePort();
    void makeRefresh();
    void pick() { m_isPicked = true; }
    void showPorts();
    void showAdapter();

    std::vector<PortRow> m_ports;
    QComboBox *m_port;
    QPushButton *m_refresh;
    QLabel *m_adapter;
    InlineMessage *m_trouble;
    bool m_isPicked = false;
};

} // namespace codewheel
