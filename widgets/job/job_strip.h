// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/encoder_session.h"

#include <QPointer>
#include <QWidget>

class QLabel;
class QProgressBar;
class QPushButton;

namespace codewheel {

class CancelQuestion;

// Where a job of the encoder stands, with Cancel. Once the encoder has taken something, Cancel asks how to
// leave it; the job goes on meanwhile.
class JobStrip : public QWidget
{
    Q_OBJECT

public:
    explicit JobStrip(QWidget *parent = nullptr);

    void setEncoder(EncoderSession *encoder);
    void begin();

private:
    void showProgress(const Progress &progress);
    void cancel();
    void ask();
    void goOn();
    void leave(OnCancel how);

    QPointer<EncoderSession> m_encoder;
    Progress m_progress;
    bool m_asksIfTaken = false; // cancelled as long as nothing was taken
    QLabel *m_step;
    QProgressBar *m_bar;
    QPushButton *m_cancel;
    CancelQuestion *m_question;
};

} // namespace codewheel
