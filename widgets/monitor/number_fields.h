// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/monitor/monitor_display.h"
#include "widgets/monitor/number_field.h"
#include "widgets/monitor/word_field.h"
#include "widgets/monitor/word_form.h"

#include <QHash>

class QLabel;

namespace codewheel {

// A word as numbers: hexadecimal and decimal in a row; signed, Gray and binary, beside their names, in
// more(). Only hexadecimal can be typed, and only where the word can be written; what is typed is checked
// with every key.
class NumberFields : public QWidget
{
    Q_OBJECT

public:
    // place: "OUT 1.0"
    NumberFields(const QString &place, const WordForm &form, bool editable, QWidget *parent = nullptr);

    // What is being typed stays as it was typed, for as long as it says this word, or no word at all.
    void setWord(Word word);
    void setDisplay(const MonitorDisplay &display);
    void setOld(bool old); // the word is of before: grey
    void restore();        // hexadecimal says the word again, whatever was typed
    WordField *hexadecimal() const { return m_hex; }
    QWidget *more() const { return m_more; } // hidden where none of them is shown; to be put in its place

Q_SIGNALS:
    void wordTyped(codewheel::Word word);         // with every key that makes a word
    void problemChanged(const QString &sentence); // empty: it is gone
    void entered();                               // Return, on a good word: it is selected

protected:
    void changeEvent(QEvent *event) override;

private:
    void showAge();
    QLabel *captionOf(QWidget *field, const QString &caption);
    void show(QWidget *field, bool shown); // with its caption
    void hexTyped(const QString &text);
    void hexLeft();
    void setProblem(const QString &sentence);
    void showNumbers();
    int numberBits() const;

    WordForm m_form;
    WordField *m_hex;
    NumberField *m_decimal;
    QWidget *m_more;
    NumberField *m_signed;
    NumberField *m_gray;
    NumberField *m_binary;
    QHash<QWidget *, QLabel *> m_captions;
    MonitorDisplay m_display;
    Word m_word = 0;
    bool m_old = false;
};

} // namespace codewheel
