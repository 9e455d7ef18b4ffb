// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/gateway/word_reading.h"
#include "vocabulary/place.h"
#include "widgets/look/page.h"

class QLabel;
class QPushButton;
class QTableView;

namespace codewheel {

class InlineMessage;
class WordReadingsModel;
struct DeviceRegisters;

// Which registers each device of a ring behind a gateway has, and what they show: its word in the four orders
// side by side, with which of them the encoder could have sent. The order is set here, once for all devices
// and both directions.
class RegistersPage : public Page
{
    Q_OBJECT

public:
    explicit RegistersPage(QWidget *parent = nullptr);
    ~RegistersPage() override;

    QString title() const override { return tr("Registers"); }
    QString effect() const override;

    // `isLive`: of the connected bus, frame by frame; otherwise as planned, or as read by "Read now".
    void show(std::vector<DeviceRegisters> devices, WordOrder set, bool isLive);
    void choose(const NodeId &device); // if it is there
    void setReading(bool on);
    void tell(const QString &sentence); // how "Read now" ended; empty: nothing to say

Q_SIGNALS:
    void readWanted(const codewheel::NodeId &device);
    void orderWanted(codewheel::WordOrder order); // abcd or cdab

private:
    void makeTable();
    int chosen() const; // -1: none
    void showChosen();
    void showOrder();
    void showButtons();
    void read();

    WordReadingsModel *m_model;
    QTableView *m_table;
    QLabel *m_meanings;
    InlineMessage *m_told;
    InlineMessage *m_order;
    QPushButton *m_read;
    QPushButton *m_swap;
    WordOrder m_set = WordOrder::abcd;
    bool m_isLive = false;
    bool m_isReading = false;
};

} // namespace codewheel
