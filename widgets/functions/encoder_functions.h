// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/encoder_session.h"

#include <QAction>
#include <QPointer>

namespace codewheel {

class Buses;

// What an encoder can do besides its parameters: position and velocity mode, FRABA preset, reset to factory
// settings. Actions for menus, shown as far as the encoder has them; those with a cost or loss ask first. The
// encoder session reports how a job ends.
class EncoderFunctions : public QObject
{
    Q_OBJECT

public:
    // Questions are asked on `window`. The buses must outlive it.
    EncoderFunctions(const Buses &buses, QWidget *window);

    void setEncoder(EncoderSession *encoder);
    QList<QAction *> actions() const
    {
        return {m_isInPositionMode, m_position, m_velocity, m_frabaPreset, m_reset};
    }
    QAction &isInPositionMode() const { return *m_isInPositionMode; }
    // Whether this job is the reset that was started here.
    bool isReset(JobId job) const { return m_resetJob == job; }
    // In Watch it says so, before anything is asked that leads to nothing.
    bool isRefusedInWatch();

Q_SIGNALS:
    void refused(const codewheel::Refusal &why);

private:
    void show();
    QString modeNow() const; // "velocity mode", "not known"
    void describeFrabaPreset();
    void tellPositionMode();
    void goToPositionMode();
    void goToVelocityMode();
    void setToPreset();
    void reset();
    void startInPositionMode(const Job &job);
    Word firstWord(const Job &job) const;
    std::optional<JobId> start(const Job &job);
    void finished(const Outcome &outcome);

    const Buses &m_buses;
    QWidget *m_window;
    QPointer<EncoderSession> m_encoder;
    QAction *m_isInPositionMode; // told by the user
    QAction *m_position;
    QAction *m_velocity;
    QAction *m_frabaPreset;
    QAction *m_reset;
    std::optional<JobId> m_resetJob;
    std::optional<JobId> m_switchJob; // into position mode, for
    Job m_next;
};

} // namespace codewheel
