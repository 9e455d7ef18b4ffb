// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/job/cancel_question.h"

#include <functional>

namespace codewheel {

// Cancels an encoder's job, wherever the button is: at once while the encoder has taken nothing; afterwards
// it asks how to leave the encoder, while the job goes on. Used by JobStrip and the wizard.
class JobCancel : public QObject
{
    Q_OBJECT

public:
    using Situation = std::function<CancelSituation(const EncoderSession &, const Progress &)>;

    // Asks in `question`, if given; otherwise in a dialog on the window of `view`.
    explicit JobCancel(QWidget *view, CancelQuestion *question = nullptr, Situation situation = situationOf);

    void begin(EncoderSession *encoder); // its job; null: none
    void follow(const Progress &progress);
    void cancel();

Q_SIGNALS:
    void leaves(codewheel::OnCancel how);
    void goesOn(); // after all

private:
    void ask();

    QWidget *m_view;
    CancelQuestion *m_question;
    Situation m_situation;
    QPointer<EncoderSession> m_encoder;
    Progress m_progress;
    bool m_asksIfTaken = false; // cancelled while nothing had been taken
};

} // namespace codewheel
