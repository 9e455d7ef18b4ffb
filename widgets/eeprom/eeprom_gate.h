// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "journal/eeprom_cost.h"

#include <QPointer>
#include <QWidget>

class QCheckBox;
class QLabel;
class QLineEdit;

namespace codewheel {

// The most writes that are about to be made to an EEPROM.
struct EepromWrites
{
    QPointer<EncoderSession> encoder;
    int planned = 0;
};

// Shown where jobs are about to be started that write to EEPROMs. Counts the writes of an encoder; from three
// quarters of the manual's figure it warns, then wants a tick, and beyond what the manual guarantees the
// place typed. Whoever starts the job asks isOpen(). Used in the reviews of wizard, parameters and cams, in
// transfers, and in EepromQuestion.
class EepromGate : public QWidget
{
    Q_OBJECT

public:
    explicit EepromGate(QWidget *parent = nullptr);

    // An agreement holds as long as encoders and concern stay the same.
    void setWrites(EncoderSession &encoder, int planned);
    // For several encoders: each that gives cause for concern is named by its place.
    void setWrites(std::vector<EepromWrites> writes);
    bool isOpen() const;

Q_SIGNALS:
    void changed(); // isOpen() may have changed

private:
    void take(std::vector<EepromWrites> writes);
    void showConcern();
    void drawIcon();

    std::vector<EepromWrites> m_writes;
    bool m_isOne = true;
    using Encoders = std::vector<QPointer<EncoderSession>>;
    Encoders m_asked; // need a tick
    Encoders m_typed; // need their places typed
    QLabel *m_count;
    QLabel *m_icon;
    QLabel *m_text;
    QCheckBox *m_nevertheless;
    QLineEdit *m_place;
};

} // namespace codewheel
