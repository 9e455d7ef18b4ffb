// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/job.h"

#include <QWidget>

class QLabel;
class QPushButton;

namespace codewheel {

// Asks which mode to leave the encoder in where its present mode is not known: cams are read and written in
// cam mode. Hidden until asked.
class CamModeBar : public QWidget
{
    Q_OBJECT

public:
    explicit CamModeBar(QWidget *parent = nullptr);

    // The programs' names: "Stay in program 3".
    void ask(unsigned program);

Q_SIGNALS:
    void answered(const codewheel::SwitchMode &afterwards);

protected:
    void keyPressEvent(QKeyEvent *event) override;

private:
    void answer(const SwitchMode &afterwards);

    unsigned m_program = 1;
    QLabel *m_question;
    QPushButton *m_position;
    QPushButton *m_cams;
    QPushButton *m_cancel;
};

} // namespace codewheel
