// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointer>
#include <QScrollArea>

class QFormLayout;
class QLabel;
class QTableView;

namespace codewheel {

class InlineMessage;
class LineFiguresModel;
class LineSession;
class RoleLabel;

// The serial line at a glance: port, baud rate, state, and how it does, as a whole and encoder by encoder.
class LinePanel : public QScrollArea
{
    Q_OBJECT

public:
    explicit LinePanel(QWidget *parent = nullptr);
    ~LinePanel() override;

    void setLine(codewheel::LineSession *line); // null: none
    // What else there is to say of the port, such as an adapter that refuses low latency; empty: nothing.
    void setNote(const QString &sentence);

    QSize sizeHint() const override;

private:
    QLabel *addLine(QFormLayout &form, const QString &caption, const QString &toolTip);
    void makeTable();
    void showState();
    void showFigures();

    QPointer<LineSession> m_line;
    QWidget *m_content;
    RoleLabel *m_state;
    QLabel *m_port = nullptr;
    QLabel *m_rate = nullptr;
    QLabel *m_latency = nullptr;
    QLabel *m_polling = nullptr;
    QLabel *m_mode = nullptr;
    InlineMessage *m_note;
    LineFiguresModel *m_figures;
    QTableView *m_table;
    QLabel *m_dropped;
};

} // namespace codewheel
