// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/instant.h"

#include <QWidget>

class QLabel;
class QLineEdit;

namespace codewheel {

// Asks for the text of a note at a moment. Hidden until then; Return takes the text, Esc does not.
class NoteBar : public QWidget
{
    Q_OBJECT

public:
    explicit NoteBar(QWidget *parent = nullptr);

    // `before`: the note that stands there; empty: none.
    void ask(Instant at, const QString &moment, const QString &before);

Q_SIGNALS:
    void noted(codewheel::Instant at, const QString &text); // empty: the note goes
    void closed();

protected:
    void keyPressEvent(QKeyEvent *event) override;

private:
    void end(bool isTaken);

    Instant m_at{};
    QLabel *m_where;
    QLineEdit *m_text;
};

} // namespace codewheel
