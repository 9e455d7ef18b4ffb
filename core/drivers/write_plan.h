// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "drivers/value_notes.h"
#include "drivers/values_to_write.h"

#include <vector>

namespace codewheel {

// What writing the wanted values means, to be looked at before anything is sent.
struct WritePlan
{
    struct Row
    {
        ParameterValue value;
        std::optional<Known> known;
        Step step;              // which carries it: its word, or its request
        bool goesAlong = false; // computed from the others: the factor of a serial encoder
    };

    WriteParameters job{};
    std::vector<Row> rows{};          // what is sent, in its order
    ParameterValues leftOut{};        // wanted, and known to be there already
    std::optional<Refusal> refusal{}; // why the job cannot be planned; there are no rows then
    // The encoder may count steps minus 1, which is read before the first word: the word for the steps may be
    // one less.
    bool stepsMayBeLess = false;
    std::vector<ValueNote> notes{}; // what else the values bring about
};

// What goes out with a step: its word, "020000FF", or its request, "03GP00005200".
QString sentText(const Step &step);

// Leaves out what the encoder is known to have, unless all is to be written. What is told and could be read
// is read by the job first.
WritePlan planWrite(const EncoderSession &encoder, const WriteWish &wish);

} // namespace codewheel
