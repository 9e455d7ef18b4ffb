// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/icons.h"
#include "widgets/look/scrolled_panel.h"

class QLabel;
class QProgressBar;
class QPushButton;
class QTableView;
class QVBoxLayout;

namespace codewheel {

class RingSession;
class InlineMessage;
class RoleLabel;
class SegmentModel;
struct MasterStatus;
struct SegmentRow;
class StatusBits;

// What the ring's master reports: state, status bits, fault and its location, the configuration it keeps, and
// the segments with their CRC errors; and its commands. Those that change the ring need Operate; before a
// segment is switched off, the devices that go with it are named. Used by the master dock.
class MasterPanel : public ScrolledPanel
{
    Q_OBJECT

public:
    // The bus outlives the panel.
    explicit MasterPanel(RingSession &bus, QWidget *parent = nullptr);
    ~MasterPanel() override;

    // Switches the segment on again, or asks whether to switch it off.
    void toggleSegment(int segment);

Q_SIGNALS:
    // Something may have to be asked first.
    void startRequested();
    void stopRequested();
    void readInRequested();
    void asked(); // a question or a refusal is shown in the panel

private:
    void makeState(QVBoxLayout *column);
    void makeButtons(QVBoxLayout *column);
    void makeSegments(QVBoxLayout *column);
    QPushButton *addButton(Icon icon, const QString &text, const QString &toolTip);
    void refresh();
    const MasterStatus *master() const; // null: not connected, or not reached
    void showState();
    void showFault();
    void showReadIn();
    void showSegmentButton();
    int chosenSegment() const; // 0: none
    const SegmentRow *findSegment(int segment) const;
    bool mayChangeRing(); // if not, it says why
    void askForSegment(int segment);
    void switchAskedSegmentOff();
    void withdrawWhatIsOver();

    RingSession &m_bus;
    RoleLabel *m_state;
    QLabel *m_fault = nullptr;
    QLabel *m_errorCode = nullptr;
    QLabel *m_parameter = nullptr;
    QLabel *m_configuration = nullptr;
    StatusBits *m_bits;
    QPushButton *m_start = nullptr;
    QPushButton *m_stop = nullptr;
    QPushButton *m_readIn = nullptr;
    QPushButton *m_confirm = nullptr;
    QProgressBar *m_progress;
    SegmentModel *m_segments;
    QTableView *m_table;
    QPushButton *m_switch = nullptr;
    InlineMessage *m_message;
    int m_askedSegment = 0; // by the message; 0: it is a refusal, or there is none
};

} // namespace codewheel
