// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/place.h"

#include <QJsonArray>
#include <QString>

namespace codewheel {

class EncoderSession;

// What goes over a bus while jobs run, for --trace. Collects as long as it lives; for a bus that reports no
// traffic, nothing.
class JobTrace
{
public:
    JobTrace() = default;
    virtual ~JobTrace() = default;
    Q_DISABLE_COPY_MOVE(JobTrace)

    virtual void begin(const EncoderSession &) {} // the state of the encoder before a job
    // For the encoder at this place.
    virtual QString text(Place) const { return {}; }
    virtual QJsonArray json(Place) const { return {}; }
};

} // namespace codewheel
