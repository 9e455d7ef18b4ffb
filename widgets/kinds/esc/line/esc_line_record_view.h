// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/esc/line/esc_line_replay.h"
#include "kinds/esc/line/row_text.h"
#include "kinds/esc/protocol/esc_explain.h"

#include <QPointer>
#include <QWidget>

class QLabel;
class QPushButton;
class QTableView;

namespace codewheel {

class InlineMessage;
class TrafficTable;
class EscLineSession;
class ReplayModel;
class TrafficModel;

// A recorded session of a serial line, to be looked at and sent again to the present line. Sends reads only,
// unless the user agrees to a question that names the writes. Used by the terminal.
class EscLineRecordView : public QWidget
{
    Q_OBJECT

public:
    explicit EscLineRecordView(QWidget *parent = nullptr);

    void setLine(EscLineSession *line); // null: none
    void setExplainOptions(const esc::ExplainOptions &options);
    void showRecord(const EscLineRecord &record, const QString &name);

Q_SIGNALS:
    void left(); // back to the line

private:
    QPushButton *addButton(QLayout &row, const QString &text, const QString &toolTip);
    void connectReplay();
    void leave();
    void replay();
    void askForWrites(const std::vector<ReplayStep> &steps, int writes);
    void begin(bool withWrites);
    void showEnd(EscLineReplay::End how);
    void showWhatIsPossible();

    QPointer<EscLineSession> m_line;
    EscLineRecord m_record;
    esc::ExplainOptions m_options;
    EscLineReplay *m_replay;
    EscLineTraffic m_traffic;
    TrafficModel *m_rows;
    ReplayModel *m_steps;
    QLabel *m_title;
    QPushButton *m_start = nullptr;
    QPushButton *m_cancel = nullptr;
    TrafficTable *m_table;
    InlineMessage *m_question;
    InlineMessage *m_message;
    QTableView *m_stepTable;
};

} // namespace codewheel
