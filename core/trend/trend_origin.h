// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "history/mark.h"
#include "history/values_since.h"
#include "vocabulary/known.h"

#include <QDateTime>

#include <deque>

namespace codewheel {

class EncoderSession;

struct TrendValue
{
    Parameter parameter = Parameter::steps;
    Value value = 0;
    std::optional<Evidence> evidence{}; // nothing: a recording does not say
    QDateTime at;                       // UTC
};

// What is known of an encoder whose values a trend has.
struct TrendEncoder
{
    Place place;
    QString station{};    // empty: none
    QString busName{};    // empty: none
    QString device{};     // the key of its description; empty: not known
    QString deviceName{}; // "FRABA OCD-IB K3"
    std::optional<double> stepsPerTurn{};
    std::vector<TrendValue> values{};
};

// As the encoder has it now; the rest is known to the project.
TrendEncoder trendEncoder(const EncoderSession &encoder);
// Of a recording: the newest, each since it is the same. `known`: oldest first.
std::vector<TrendValue> recordedValues(const std::vector<ValuesSince> &known);

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
