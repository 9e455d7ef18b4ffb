// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLineEdit>
#include <QPlainTextEdit>

namespace codewheel {

// A line of text in a form: taken when the field is left or Return is pressed. Esc restores the previous
// text.
class TextField : public QLineEdit
{
    Q_OBJECT

public:
    explicit TextField(QWidget *parent = nullptr);

    // The text set or taken last, without what is being typed.
    const QString &takenText() const { return m_taken; }

Q_SIGNALS:
    void taken(const QString &text); // by the user, and different from before

protected:
    void keyPressEvent(QKeyEvent *event) override;

private:
    void take();

    QString m_taken;
};

// A text of several lines: taken when the field is left. Esc restores the previous text.
class NoteField : public QPlainTextEdit
{
    Q_OBJECT

public:
    explicit NoteField(QWidget *parent = nullptr);

    const QString &takenText() const { return m_taken; }
    void setTakenText(const QString &text);

Q_SIGNALS:
    void taken(const QString &text);

protected:
    void keyPressEvent(QKeyEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;

private:
    QString m_taken;
};

// Takes what is in the focused field, as leaving it would: for saving or closing while somebody is typing.
// The focus stays.
void takeFocusedField();

} // namespace codewheel
