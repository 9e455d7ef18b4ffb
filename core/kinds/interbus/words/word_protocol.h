// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "jobs/protocol.h"
#include "kinds/interbus/make_driver.h"
#include "kinds/interbus/words/word_step.h"

namespace codewheel {

// Of encoders with words.
class WordProtocol : public Protocol
{
public:
    QString stepText(const DeviceDescription &device, const Step &step) const override
    {
        return wordStepText(device, step);
    }
    std::optional<Reading> readingOf(const DeviceDescription &device, const std::vector<Known> &known,
                                     Word in, Word out, Instant at) const override
    {
        return readingOfWords(device, known, in, out, at);
    }
};

} // namespace codewheel
