// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/icons.h"

#include <QScrollArea>

class QFormLayout;
class QLabel;
class QProgressBar;
class QPushButton;
class QTableView;
class QVBoxLayout;

namespace codewheel {

class BusSession;
class EmptyState;
class RoleLabel;
class SegmentModel;
class StatusBits;

// What the ring's master says: state, status bits, fault and where it is, the configuration it keeps, and the
// segments with their CRC errors; and what can be asked of it. Used by the master dock.
class MasterPanel : public QScrollArea
{
    Q_OBJECT

public:
    // The bus outlives the panel.
    explicit MasterPanel(BusSession &bus, QWidget *parent = nullptr);
    ~MasterPanel() override;

    // Switches the segment off, or on again.
    void toggleSegment(int segment);

    QSize sizeHint() const override;

Q_SIGNALS:
    // Something may have to be asked before.
    void startRequested();
    void stopRequested();
    void readInRequested();

private:
    void makeState(QVBoxLayout *column);
    void makeButtons(QVBoxLayout *column);
    void makeSegments(QVBoxLayout *column);
    QLabel *addLine(QFormLayout *form, const QString &caption, const QString &toolTip);
    QPushButton *addButton(Icon icon, const QString &text, const QString &toolTip);
    void refresh();
    void showFault();
    void showReadIn();
    void showSegmentButton();
    int chosenSegment() const; // 0: none

    BusSession &m_bus;
    QWidget *m_content;
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
};

} // namespace codewheel
