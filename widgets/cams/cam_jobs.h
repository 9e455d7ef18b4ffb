// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/encoder_session.h"

#include <QPointer>

#include <map>

namespace codewheel {

// The jobs the cam editor has given to encoders, and their purposes. They go on when another encoder is
// chosen.
class CamJobs : public QObject
{
    Q_OBJECT

public:
    enum class Purpose { findRange, read, compare, write, switchMode };

    using QObject::QObject;

    Result<void> start(EncoderSession &encoder, Purpose purpose, const Job &job);

Q_SIGNALS:
    void ended(codewheel::Place number, codewheel::CamJobs::Purpose purpose,
               const codewheel::Outcome &outcome);

private:
    struct Running
    {
        JobId job = 0;
        Purpose purpose = Purpose::read;
        QMetaObject::Connection connection;
    };
    void finish(Place number, const Outcome &outcome);

    std::map<Place, Running> m_running;
};

// The encoder's mode now, for a job to leave it in; nothing where it is not known.
std::optional<SwitchMode> modeNow(const EncoderSession &encoder);

} // namespace codewheel
