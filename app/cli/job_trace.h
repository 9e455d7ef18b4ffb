// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/place.h"

#include <QJsonArray>
#include <QString>

namespace codewheel {

class EncoderSession;

// What goes over a bus while jobs run, for --trace. Collects as long as it lives; of a bus that tells nothing
// of it, nothing.
class JobTrace
{
public:
    JobTrace() = default;
    virtual ~JobTrace() = default;
    Q_DISABLE_COPY_MOVE(JobTrace)

    virtual void begin(const EncoderSession &) {} // how the encoder stands before a job
    // Of the encoder at this place.
    virtual QString text(Place) const { return {}; }
    virtual QJsonArray json(Place) const { return {}; }
};

} // namespace codewheel
