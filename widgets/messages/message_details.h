// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

class QLabel;

namespace codewheel {

class MessageModel;

// One row of the messages in full, selectable: date and time to the millisecond, severity, place, how often,
// and the text.
class MessageDetails : public QFrame
{
    Q_OBJECT

public:
    explicit MessageDetails(QWidget *parent = nullptr);

    void show(const MessageModel &messages, int row);
    using QFrame::show;

private:
    QLabel *m_head;
    QLabel *m_text;
};

} // namespace codewheel
