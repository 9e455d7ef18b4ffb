// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/encoder_session.h"

#include <QPointer>
#include <QWidget>

#include <functional>

class QLabel;
class QPushButton;

namespace codewheel {

// What the encoder has taken by the time a job is to be cancelled.
struct CancelSituation
{
    ParameterValues taken;     // by the encoder so far
    bool tookCams = false;     // these are acknowledged one by one, too
    bool isActive = false;     // it is valid already: run was sent, and nothing since
    bool canRestore = false;   // the previous values are known, and the position was not set
    bool setsPosition = false; // or may have
    int writesToRestore = 0;   // to the EEPROM, at most
    // What the position will read if it keeps what it has, or that it is not known; asked again as the shaft
    // moves. May be empty.
    std::function<QString()> positionNote{};
};

// For a job whose latest progress this is.
CancelSituation situationOf(const EncoderSession &encoder, const Progress &progress);

// Cancelling a job after the encoder has taken something: restore the previous values, run with what it has,
// leave it as it is, or go on. Before that (Progress::hasTaken) there is nothing to ask:
// OnCancel::ifNothingTaken. Restoring writes to the EEPROM; where that needs consent, it is asked for as
// well. Used in the strip of a job, and in a dialog.
class CancelQuestion : public QWidget
{
    Q_OBJECT

public:
    explicit CancelQuestion(QWidget *parent = nullptr);

    void ask(EncoderSession &encoder, const CancelSituation &situation);

Q_SIGNALS:
    void answered(codewheel::OnCancel how);
    void goesOn();

private:
    void answer(OnCancel how);
    void explain();

    QPointer<EncoderSession> m_encoder;
    CancelSituation m_situation;
    QLabel *m_text;
    QPushButton *m_restore;
    QPushButton *m_run;
    QPushButton *m_leave;
    QPushButton *m_goOn;
};

// In a dialog. Nothing: go on with the handshake; also if the job has ended meanwhile. Used by the wizard and
// by transfers.
std::optional<OnCancel> askHowToCancel(QWidget *parent, EncoderSession &encoder,
                                       const CancelSituation &situation);

} // namespace codewheel
