// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "can/can_frame.h"
#include "vocabulary/refusal.h"

#include <QPointer>
#include <QWidget>

class QLineEdit;
class QPushButton;

namespace codewheel {

class CanopenSession;
class InlineMessage;
class MeaningLine;
struct FrameSent;

// A frame by hand, written as in the logs of candump, with what it says. A read of an object is sent at once;
// anything else may set a machine in motion, and is sent after a question.
class SendFrameBar : public QWidget
{
    Q_OBJECT

public:
    explicit SendFrameBar(QWidget *parent = nullptr);

    void setBus(codewheel::CanopenSession *bus); // null: none
    void setRecordingChosen(bool isChosen);

Q_SIGNALS:
    void sent();

private:
    void showMeaning();
    void showWhatIsPossible();
    std::optional<Refusal> whyNotSent() const;
    std::optional<CanFrame> typed(); // says why it is none
    void send();
    void ask(const CanFrame &frame);
    void sendNow(const CanFrame &frame);
    void takeEnd(const FrameSent &ended);

    QPointer<CanopenSession> m_bus;
    bool m_isRecordingChosen = false;
    std::optional<CanFrame> m_asked; // that the question is about
    QLineEdit *m_field;
    QPushButton *m_send;
    MeaningLine *m_meaning;
    InlineMessage *m_question;
    InlineMessage *m_message;
};

} // namespace codewheel
