// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/monitor/monitor_display.h"
#include "widgets/monitor/position_range.h"
#include "widgets/monitor/word_layout.h"
#include "widgets/monitor/word_line.h"

#include <QFrame>

class QHBoxLayout;
class QToolButton;

namespace codewheel {

class AgeTimer;
class BarView;
class DisplayMenu;
class InlineMessage;
class WordView;
struct Track;

// The words of one device: OUT above IN, bit under bit, each as numbers and in a sentence. An OUT word is
// staged by clicking and typing, and sent by Write. Part of the MonitorArea, which passes on each frame of
// the bus.
//
// Keys: Ctrl+Return writes, Esc discards, Ctrl+C copies the word chosen last, Ctrl+Shift+C copies it as the
// two words of a PLC.
class WordCard : public QFrame
{
    Q_OBJECT

public:
    // encoder, device: null if the make is not known. They and the channel may end before the card.
    WordCard(WordChannel &channel, EncoderSession *encoder, const DeviceDescription *device,
             QWidget *parent = nullptr);

    // Whether the device has words.
    static bool canShow(const WordChannel &channel);
    // Its place has a new name: the card has to be replaced.
    bool isNamedAnew() const;
    Place place() const { return m_place; }
    const WordChannel *channel() const { return m_channel; } // null: it has ended
    const EncoderSession *encoder() const { return m_encoder; }

    void setStation(const QString &station); // the device's name at the plant; empty: none
    QString title() const;                   // "1.0  Hoist  FRABA OCD-IB K3"
    void setDisplay(const MonitorDisplay &display);
    void setPinned(bool pinned);
    bool isPinned() const;

    // A frame of the bus was taken at `now`.
    void showFrame(Instant now);
    // Watch, Operate, start or stop: what was refused may be allowed now.
    void busStateChanged();

    // Null: the device has no such word.
    const WordLine *line(WordDirection direction) const;

Q_SIGNALS:
    void closeRequested();
    void pinToggled(bool pinned);                                 // by the user
    void displayChosen(const codewheel::MonitorDisplay &display); // by the user
    void trendWanted(const codewheel::Track &track);

private:
    // Why the message is shown; it goes with its cause.
    enum class Cause : std::uint8_t { none, badInput, refusal, question };

    void makeLines();
    QHBoxLayout *makeTitle();
    void arrange(QHBoxLayout *title);
    void orderTabs(const QLayout &title);
    void makeSender(WordSender &sender, NumberFields &numbers);
    void makeKeys();
    void makeTrendActions();
    void copy(WordNotation notation); // the word that was chosen last
    WordLine *outLine() const;
    const WordLine &chosenLine() const;

    void stageBit(WordBit bit);
    void stageTyped(Word word);
    void showProblem(const QString &sentence);
    void showWords(bool withEdges);
    void showRange();
    void showRefusal(const Refusal &why);
    void askBeforeSending(Word word);
    void withdraw(Cause cause);

    QPointer<WordChannel> m_channel;
    QPointer<EncoderSession> m_encoder;
    const DeviceDescription *m_device;
    Place m_place;
    QString m_shownPlace;
    DisplayMenu *m_menu;
    MeaningLine *m_title;
    QToolButton *m_pin;
    std::vector<WordLine *> m_lines; // from top to bottom
    WordView *m_bits;
    BarView *m_bar;
    InlineMessage *m_message;
    MonitorDisplay m_display;
    std::optional<PositionRange> m_range;
    Cause m_cause = Cause::none;
    bool m_isTyping = false;
    std::optional<Word> m_stagedBefore; // before the typing began
    bool m_hasSent = false;             // a refusal that comes back now is for a word sent from here
    Instant m_now{};
    AgeTimer *m_age;
};

} // namespace codewheel
