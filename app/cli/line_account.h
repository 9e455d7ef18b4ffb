// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/bus_access.h"

#include <QJsonArray>

namespace codewheel {

// What became of values that were to be written to an encoder on a serial line: nothing is said of a value
// that nobody knows.
class LineAccount
{
public:
    LineAccount(const EncoderSession &encoder, const ParameterValues &wanted, const FinishedJob &job)
        : m_encoder(encoder)
        , m_wanted(wanted)
        , m_job(job)
    {}

    QString toText() const;
    // {"parameter", "value", ..., "fate"}
    QJsonArray toJson() const;
    // How the encoder was left, in a sentence.
    QString whereItWasLeft() const;

private:
    enum class Fate { readBack, accepted, alreadyThere, unknown, refused, notSent };

    Fate fateOf(const ParameterValue &value) const;
    bool wasSent(Parameter parameter) const;

    const EncoderSession &m_encoder;
    const ParameterValues &m_wanted;
    const FinishedJob &m_job;
};

} // namespace codewheel
