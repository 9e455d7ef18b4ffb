// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "transfer/job_round.h"

#include <QWidget>

class QLabel;
class QProgressBar;
class QPushButton;

namespace codewheel {

// Where a round of jobs stands, with Cancel: encoder i of n, and the step of its job. Cancel asks how to
// leave an encoder that has taken something, and begins no other. Stands in TransferPage and ReplacePage.
class TransferProgress : public QWidget
{
    Q_OBJECT

public:
    explicit TransferProgress(JobRound &round, QWidget *parent = nullptr);

    void cancel();

private:
    void showProgress();
    void ask();

    JobRound &m_round;
    QLabel *m_text;
    QProgressBar *m_encoders;
    QProgressBar *m_steps;
    QPushButton *m_cancel;
    bool m_asksIfTaken = false; // cancelled as long as nothing was taken
};

} // namespace codewheel
