// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/word_channel.h"
#include "catalog/word_form.h"

#include <QPointer>
#include <QWidget>

#include <functional>

class QCheckBox;
class QPushButton;

namespace codewheel {

// Sends an OUT word: Write, Discard, and "At once", which the monitor places itself. "At once" is off in
// every new monitor, and even when it is on, a word with a command bit or a parameter number is sent only if
// the user confirms it: clicking bit 25 alone means steps = 0.
class WordSender : public QWidget
{
    Q_OBJECT

public:
    // place: "OUT 1.0"
    WordSender(WordChannel &channel, const QString &place, const WordForm &form, QWidget *parent = nullptr);

    // Asked before a word is sent, whether it may be.
    void setGate(std::function<bool(Word)> mayBeSent) { m_mayBeSent = std::move(mayBeSent); }
    void setBlocked(bool blocked); // by bad input, which must not be taken for the word sent
    void write();
    void discard();
    void edited(); // the user has staged a whole word: it is sent if "At once" is on
    void showStaged();
    void showWhetherSent(); // nothing is sent to a recording
    QCheckBox *atOnce() const { return m_atOnce; }

Q_SIGNALS:
    void refused(const codewheel::Refusal &why);
    void askedFor(codewheel::Word word); // to be sent at once, but only if the user agrees
    void sent();
    void discarded();

private:
    QPointer<WordChannel> m_channel;
    Word m_commandBits;
    std::function<bool(Word)> m_mayBeSent;
    QPushButton *m_write;
    QPushButton *m_discard;
    QCheckBox *m_atOnce;
    bool m_blocked = false;
};

} // namespace codewheel
