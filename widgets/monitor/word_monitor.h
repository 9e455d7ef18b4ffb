// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/word_channel.h"
#include "encoder/encoder_session.h"
#include "widgets/monitor/monitor_display.h"
#include "widgets/monitor/monitor_kind.h"
#include "widgets/monitor/position_range.h"

#include <QFrame>
#include <QPointer>

class QComboBox;
class QHBoxLayout;
class QLabel;

namespace codewheel {

class AgeTimer;
class BarView;
class DisplayMenu;
class InlineMessage;
class MeaningLine;
class NumberFields;
class WordSender;
class WordView;

// One word of one device, as bits, as numbers and in a sentence. An OUT word is staged by clicking and
// typing, and sent by Write. Stands in the MonitorArea, which tells it of each picture of the bus.
//
// Keys: Ctrl+Return writes, Esc discards, Ctrl+C copies the word, Ctrl+Shift+C as the two words of a PLC.
class WordMonitor : public QFrame
{
    Q_OBJECT

public:
    // encoder, device: null where the make is not known. They and the channel may end before the monitor.
    WordMonitor(WordChannel &channel, EncoderSession *encoder, const DeviceDescription *device,
                MonitorKind kind, QWidget *parent = nullptr);

    // Its place has another name now: it is to be made anew.
    bool isNamedAnew() const;
    Place place() const { return m_place; }
    MonitorKind kind() const { return m_kind; }
    const WordChannel *channel() const { return m_channel; } // null: it has ended
    const EncoderSession *encoder() const { return m_encoder; }

    void setDisplay(const MonitorDisplay &display);
    // IN 16 of a device with 32 bits: D31..D16 or D15..D0.
    void setHighHalf(bool high);
    bool isHighHalf() const;

    // A picture of the bus was taken at now.
    void showPicture(Instant now);
    // Watch, Operate, start or stop: what was refused before may not be now.
    void busStateChanged();

    QString meaning() const; // the sentence under the word
    QString hexText() const;
    QString plcText() const;

Q_SIGNALS:
    void closeRequested();
    void displayChosen(const codewheel::MonitorDisplay &display); // by the user

private:
    // Why the message is there; it goes when the cause goes.
    enum class Cause : std::uint8_t { none, badInput, refusal, question };

    bool isOut() const { return m_kind == MonitorKind::out32; }
    Word shownWord() const;
    Word onBus() const;
    int shift() const; // of the bits shown within the word of the device

    QHBoxLayout *makeTitle();
    void makeBody(QHBoxLayout *title);
    QLabel *makeNoOutNote();
    void makeSender();
    void makeKeys();
    void addCopyAction(const QString &text, const QKeySequence &key, QString (WordMonitor::*content)() const);

    void stageTyped(Word word);
    void showProblem(const QString &sentence);
    void showWord(Word edges);
    void showRange();
    bool isOld() const;
    QString explain() const;
    void showRefusal(const Refusal &why);
    void askBeforeSending(Word word);
    void withdraw(Cause cause);

    QPointer<WordChannel> m_channel;
    QPointer<EncoderSession> m_encoder;
    const DeviceDescription *m_device;
    MonitorKind m_kind;
    Place m_place;
    QString m_wordName;
    DisplayMenu *m_menu;
    QComboBox *m_half = nullptr;
    WordView *m_bits;
    MeaningLine *m_meaning;
    NumberFields *m_places;
    BarView *m_bar = nullptr;
    WordSender *m_sender = nullptr;
    InlineMessage *m_message;
    MonitorDisplay m_display;
    std::optional<PositionRange> m_range;
    Cause m_cause = Cause::none;
    bool m_isTyping = false;
    std::optional<Word> m_stagedBefore; // before the typing began
    bool m_hasSent = false;             // what comes back as refused now was sent from here
    Instant m_now{};
    AgeTimer *m_age;
};

} // namespace codewheel
