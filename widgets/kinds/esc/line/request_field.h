// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/help/key_help.h"

#include <QLineEdit>
#include <QStringList>

namespace codewheel {

class CommandList;

// Where a request is typed: Up and Down recall earlier ones, Ctrl+Space lists all commands with their
// meaning, and so does typing. Used by the terminal.
class RequestField : public QLineEdit
{
    Q_OBJECT

public:
    static constexpr qsizetype mostKept = 200;

    explicit RequestField(QWidget *parent = nullptr);

    // Oldest first.
    const QStringList &history() const { return m_history; }
    void setHistory(const QStringList &history);
    // Those of the line, which decide what a scaling factor may be.
    void setFractionBits(int bits);
    // Adds what was typed to the history, and empties the field.
    void keep();
    static QList<KeyHelp> keys(); // that it answers

protected:
    bool event(QEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;

private:
    void makeCompletion();
    void followAddress(const QString &text);
    void goThroughHistory(qsizetype by);

    CommandList *m_commands;
    QStringList m_history;
    qsizetype m_place = 0; // in the history; past its end: what is being typed
    QString m_typed;       // kept while older ones are looked at
};

} // namespace codewheel
