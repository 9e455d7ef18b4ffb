// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "history/mark.h"
#include "project/project.h"

#include <deque>

namespace codewheel {

class EncoderSession;

// What is known of an encoder whose values a trend has.
struct TrendEncoder
{
    Place place;
    QString station{};    // empty: none
    QString busName{};    // empty: none
    QString device{};     // the key of its description; empty: not known
    QString deviceName{}; // "FRABA OCD-IB K3"
    std::optional<double> stepsPerTurn{};
    std::vector<StoredValue> values{};
};

// As the encoder has it now; the rest is known to the project.
TrendEncoder trendEncoder(const EncoderSession &encoder);

// Where a trend comes from, and what happened meanwhile.
struct TrendOrigin
{
    QString version; // of the program
    QDateTime now;   // its time zone is that of the trend
    std::vector<TrendEncoder> encoders{};
    std::deque<Mark> marks{};  // of any time
    std::uint64_t dropped = 0; // Histories::dropped()
};

} // namespace codewheel
