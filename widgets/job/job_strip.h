// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "transfer/job_round.h"

#include <QPointer>
#include <QWidget>

class QLabel;
class QProgressBar;
class QPushButton;

namespace codewheel {

class CancelQuestion;
class JobCancel;

// The progress of a job, with Cancel: that of one encoder, in its panels, or of a round of jobs, encoder i of
// n, in transfers.
class JobStrip : public QWidget
{
    Q_OBJECT

public:
    explicit JobStrip(QWidget *parent = nullptr);
    // Cancel starts no further encoder, whatever becomes of the running one. The round must outlive it.
    explicit JobStrip(JobRound &round, QWidget *parent = nullptr);

    void setEncoder(EncoderSession *encoder);
    void begin();
    void cancel();

Q_SIGNALS:
    void asks(bool isAsking); // how to cancel: the question needs the room

private:
    JobStrip(JobRound *round, QWidget *parent);
    void layOut();
    void showProgress(const Progress &progress);
    void showRound();
    QStringList roundTexts() const;
    void goOn();
    void leave(OnCancel how);

    JobRound *m_round; // null: one encoder
    QPointer<EncoderSession> m_encoder;
    QLabel *m_step;
    QProgressBar *m_encoders; // of a round
    QProgressBar *m_bar;
    QPushButton *m_button;
    CancelQuestion *m_question; // null: asked in a dialog
    JobCancel *m_cancel;
};

} // namespace codewheel
