// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/kinds/canopen/can_interface_row.h"

#include <QWidget>

class QComboBox;
class QFormLayout;
class QLabel;
class QPushButton;

namespace codewheel {

class InlineMessage;

// The CAN interface in a form: from the list or by its name, with what the system tells of it below, and what
// is in its way. Does not find them itself.
class CanInterfaceField : public QWidget
{
    Q_OBJECT

public:
    explicit CanInterfaceField(QWidget *parent = nullptr);

    // Adds its row and that of the trouble.
    void addTo(QFormLayout &form, const QString &label);

    // The choice stays, even if it is not in the list.
    void setInterfaces(const CanInterfaceRows &interfaces);
    // Of the bus, in Bd, for the commands.
    void setRate(int rate);
    QString interface() const; // empty: none is chosen
    void setInterface(const QString &name);

Q_SIGNALS:
    void refreshWanted();
    void edited();

private:
    const CanInterfaceRow *chosen() const; // null: it is not in the list
    void showList();
    void showChosen();

    CanInterfaceRows m_interfaces;
    int m_rate = 0;
    QComboBox *m_name;
    QPushButton *m_refresh;
    QLabel *m_state;
    InlineMessage *m_trouble;
};

} // namespace codewheel
