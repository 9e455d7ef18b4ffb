// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "journal/eeprom_cost.h"

#include <QPointer>
#include <QWidget>

class QCheckBox;
class QLabel;
class QLineEdit;

namespace codewheel {

// Stands where a job is about to be started that writes to an EEPROM: by what the writes are counted, and,
// from three quarters of what the manual states, what has to be known or agreed to before. Whoever starts the
// job asks isOpen(). In the reviews of wizard, parameters and cams, and in EepromQuestion.
class EepromGate : public QWidget
{
    Q_OBJECT

public:
    explicit EepromGate(QWidget *parent = nullptr);

    // So many writes at most. What was agreed to holds as long as encoder and concern stay the same.
    void setWrites(EncoderSession &encoder, int planned);
    bool isOpen() const;

Q_SIGNALS:
    void changed(); // isOpen()

protected:
    void changeEvent(QEvent *event) override;

private:
    void showConcern();
    void drawIcon();

    QPointer<EncoderSession> m_encoder;
    int m_planned = 0;
    EepromConcern m_concern = EepromConcern::none;
    QLabel *m_count;
    QLabel *m_icon;
    QLabel *m_text;
    QCheckBox *m_nevertheless;
    QLineEdit *m_place;
};

} // namespace codewheel
