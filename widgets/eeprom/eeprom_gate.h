// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "journal/eeprom_cost.h"

#include <QPointer>
#include <QWidget>

class QCheckBox;
class QLabel;
class QLineEdit;

namespace codewheel {

// What is about to be written to an EEPROM at most.
struct EepromWrites
{
    QPointer<EncoderSession> encoder;
    int planned = 0;
};

// Stands where jobs are about to be started that write to EEPROMs: by what the writes of an encoder are
// counted, and, from three quarters of what the manual states, what has to be known or agreed to before: a
// tick, and beyond what the manual guarantees the place typed. Whoever starts the job asks isOpen(). In the
// reviews of wizard, parameters and cams, in transfers, and in EepromQuestion.
class EepromGate : public QWidget
{
    Q_OBJECT

public:
    explicit EepromGate(QWidget *parent = nullptr);

    // What was agreed to holds as long as encoders and concern stay the same.
    void setWrites(EncoderSession &encoder, int planned);
    // Of several encoders: each that gives cause for concern is told by its place.
    void setWrites(std::vector<EepromWrites> writes);
    bool isOpen() const;

Q_SIGNALS:
    void changed(); // isOpen()

protected:
    void changeEvent(QEvent *event) override;

private:
    void take(std::vector<EepromWrites> writes);
    void showConcern();
    void drawIcon();

    std::vector<EepromWrites> m_writes;
    bool m_isOne = true;
    using Encoders = std::vector<QPointer<EncoderSession>>;
    Encoders m_asked; // to be ticked
    Encoders m_typed; // whose places are to be typed
    QLabel *m_count;
    QLabel *m_icon;
    QLabel *m_text;
    QCheckBox *m_nevertheless;
    QLineEdit *m_place;
};

} // namespace codewheel
