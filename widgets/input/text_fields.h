// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLineEdit>
#include <QPlainTextEdit>

namespace codewheel {

// A line of text in a form: taken when the field is left or Return is pressed. Esc gives the text before.
class TextField : public QLineEdit
{
    Q_OBJECT

public:
    explicit TextField(QWidget *parent = nullptr);

    // The text that was set or taken last; what is being typed is not.
    const QString &takenText() const { return m_taken; }

Q_SIGNALS:
    void taken(const QString &text); // by the user, and another one than before

protected:
    void keyPressEvent(QKeyEvent *event) override;

private:
    void take();

    QString m_taken;
};

// A text of several lines: taken when the field is left. Esc gives the text before.
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

// Takes what stands in the field that has the focus, as leaving it would: for who saves or closes while
// somebody types. The focus stays.
void takeFocusedField();

} // namespace codewheel
