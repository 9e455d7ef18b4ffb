// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/encoder/jobs.h"
#include "cli/encoder/write_account.h"

namespace codewheel {

// What became of values that were to be written to an encoder on a serial line: nothing is claimed of a value
// that nobody knows.
class EscLineAccount final : public WriteAccount
{
public:
    EscLineAccount(const EncoderSession &encoder, const ParameterValues &wanted, const FinishedJob &job);

    // "values": {"parameter", "value", ..., "fate"}, and "placeNow".
    QJsonObject toJson() const override;
    QString whereItWasLeft() const override;

private:
    enum class Fate { readBack, accepted, alreadyThere, unknown, refused, notSent };

    QString fateOf(const ParameterValue &value) const override;
    Fate fate(const ParameterValue &value) const;
};

} // namespace codewheel
