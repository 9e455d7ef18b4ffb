// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/word_form.h"
#include "widgets/monitor/monitor_display.h"
#include "widgets/monitor/number_field.h"
#include "widgets/monitor/word_field.h"

#include <QHash>

class QLabel;

namespace codewheel {

// A word as numbers: hexadecimal and decimal in a row; signed, Gray and binary with their names in more().
// Only hexadecimal can be edited, and only if the word can be written; input is checked with every key.
class NumberFields : public QWidget
{
    Q_OBJECT

public:
    // place: "OUT 1.0"
    NumberFields(const QString &place, const WordForm &form, bool editable, QWidget *parent = nullptr);

    // What is being typed stays as typed while it stands for this word, or for no word at all.
    void setWord(Word word);
    void setDisplay(const MonitorDisplay &display);
    void setOld(bool old); // an old word is grey
    void setKnown(bool known);
    void restore(); // hexadecimal shows the word again, whatever was typed
    WordField *hexadecimal() const { return m_hex; }
    QWidget *more() const { return m_more; } // hidden if it shows none; for the caller to place

Q_SIGNALS:
    void wordTyped(codewheel::Word word);         // with every key that gives a word
    void problemChanged(const QString &sentence); // empty: it is gone
    void entered();                               // Return on a valid word, which is then selected

private:
    void showAge();
    QLabel *captionOf(QWidget *field, const QString &caption);
    void show(QWidget *field, bool shown); // with its caption
    void hexTyped(const QString &text);
    void hexLeft();
    void setProblem(const QString &sentence);
    void showNumbers();
    QString known(const QString &number) const;
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
    bool m_isKnown = true;
};

} // namespace codewheel
