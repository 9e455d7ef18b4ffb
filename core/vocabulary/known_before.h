// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/known.h"

#include <QDateTime>

#include <optional>
#include <vector>

namespace codewheel {

// What was known of the encoder at a place when its bus was connected last. Which encoder is there by now is
// not known: the same one if it reports the same serial number, or if the user says so.
struct KnownBefore
{
    struct Entry
    {
        Parameter parameter = Parameter::steps;
        Value value = 0;
        Evidence evidence = Evidence::told;
        QDateTime at{};
        Kept kept = Kept::byItself;
    };

    std::vector<Entry> values;
    std::optional<std::int64_t> serialNumber{}; // that it reported
};

} // namespace codewheel
