// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/word_channel.h"
#include "catalog/word_form.h"
#include "vocabulary/encoder_session.h"
#include "widgets/monitor/monitor_display.h"
#include "widgets/monitor/word_format.h"

#include <QPointer>
#include <QWidget>

class QGridLayout;
class QLabel;

namespace codewheel {

class MeaningLine;
class NumberFields;
class WordSender;

// "OUT 1.0": identifies word, bits and fields, on the screen and for screen readers.
QString wordName(WordDirection direction, Place place);
QString caption(WordDirection direction); // "OUT"

// One word of a device below its bits: as numbers and in a sentence. An OUT word has Write beside it.
class WordLine : public QWidget
{
    Q_OBJECT

public:
    // The device of the word. Encoder and description are null if the make is not known; all of them may end
    // before the line.
    struct Device
    {
        WordChannel *channel = nullptr;
        EncoderSession *encoder = nullptr;
        const DeviceDescription *description = nullptr;
    };

    WordLine(WordDirection direction, const Device &device, const WordForm &form, QWidget *parent = nullptr);
    void setCaptionWidth(int width); // the same as to the left of the bits

    WordDirection direction() const { return m_direction; }
    bool isOut() const { return m_direction == WordDirection::out; }
    QString name() const { return m_name; }
    Word shown() const; // including staged changes
    Word onBus() const;
    Word edges() const;
    bool isOld() const;
    bool isKnown() const; // false: nobody recorded it, or the bus does not tell it
    QString bitText(int bit) const;
    QString meaning() const;
    QString hexText() const { return copiedText(WordNotation::hexadecimal); }
    QString copiedText(WordNotation notation) const; // the shown word

    NumberFields *numbers() const { return m_numbers; }
    WordSender *sender() const { return m_sender; } // null for IN
    void setDisplay(const MonitorDisplay &display);
    void showWord(); // updates what is shown

private:
    bool mayLackSupply() const;
    QString explain() const;
    void arrange();

    WordDirection m_direction;
    QPointer<WordChannel> m_channel;
    QPointer<EncoderSession> m_encoder;
    const DeviceDescription *m_description;
    WordForm m_form;
    QString m_name;
    QGridLayout *m_rows;
    QLabel *m_caption;
    NumberFields *m_numbers;
    MeaningLine *m_meaning;
    WordSender *m_sender = nullptr;
};

} // namespace codewheel
