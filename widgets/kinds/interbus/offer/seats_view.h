// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/kinds/interbus/offer/seats_model.h"
#include "widgets/kinds/interbus/offer/served_registers_model.h"

#include <QWidget>

#include <optional>

class QComboBox;
class QPushButton;
class QTableView;

namespace codewheel {

class SeatPanel;

// The seats of a class: how the ring of each stands, with the words of one device, and what a trainer can do
// to the chosen one. Part of OfferedView.
class SeatsView : public QWidget
{
    Q_OBJECT

public:
    explicit SeatsView(QWidget *parent = nullptr);
    ~SeatsView() override;

    void setDevices(const std::vector<ServedDevice> &devices); // of each ring; the first one is chosen
    // Whose words the table shows; empty: no device has any.
    std::optional<NodeId> device() const;
    void show(const std::vector<Seat> &seats); // frame by frame
    std::optional<int> chosen() const;         // its unit
    SeatPanel &panel() { return *m_panel; }

Q_SIGNALS:
    void restartWanted(int unit);
    void choiceChanged(); // of the seat, or of the device

private:
    void showChoice();

    SeatsModel *m_seats;
    QTableView *m_table;
    QComboBox *m_device;
    SeatPanel *m_panel;
    QPushButton *m_restart;
};

} // namespace codewheel
