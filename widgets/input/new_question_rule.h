// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/quick_press.h"

#include <QObject>
#include <QPointer>

class QDialog;

namespace codewheel {

// The second of two quick clicks, or of two quick presses of a key, does not answer the question that the
// first one has opened. ALARM STOP and Esc work at once. Installed on the application.
class NewQuestionRule : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;

    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void noteShown(QObject *watched);
    bool isAnswer(const QObject *watched) const;

    QPointer<QDialog> m_question; // the one that came last
    QuickPress m_press;
};

} // namespace codewheel
