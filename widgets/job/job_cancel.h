// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/job/cancel_question.h"

#include <functional>

namespace codewheel {

// Cancel of the job that an encoder does, wherever its button stands: at once as long as the encoder has
// taken nothing; once it has, asks how to leave it, while the job goes on. Of JobStrip and of the wizard.
class JobCancel : public QObject
{
    Q_OBJECT

public:
    using Situation = std::function<CancelSituation(const EncoderSession &, const Progress &)>;

    // Asks in `question`, where it is shown; in a dialog on the window of `view` without one.
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
    bool m_asksIfTaken = false; // cancelled as long as nothing was taken
};

} // namespace codewheel
