// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "drivers/value_notes.h"
#include "encoder/encoder_session.h"

#include <vector>

namespace codewheel {

// What writing the wanted values means, to be looked at before anything is sent.
struct WritePlan
{
    struct Row
    {
        ParameterValue value;
        std::optional<Known> old;
        Word word = 0;        // as it will stand in OUT
        QByteArray request{}; // of an encoder on a serial line, "05GP00005200"; there is no word then
    };

    WriteParameters job{};
    std::vector<Row>
        rows{}; // one for each value that is written, those that go along with the wanted ones too
    std::optional<Refusal> refusal{}; // why the job cannot be planned; there are no rows then
    int alreadyThere = 0;             // wanted, known to be there, and left out
    // The encoder may count steps minus 1, which is read before the first word: the word for the steps may be
    // one less.
    bool stepsMayBeLess = false;
    std::vector<ValueNote> notes{}; // what else the values bring about
};

// Leaves out what the encoder is known to have, unless all is to be written. What is told and could be read
// is read by the job first.
WritePlan planWrite(const EncoderSession &encoder, const ParameterValues &wanted, bool writeAll);

} // namespace codewheel
