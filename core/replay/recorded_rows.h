// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/traffic.h"
#include "catalog/profile.h"
#include "vocabulary/encoder_session.h"

#include <functional>
#include <memory>
#include <span>

namespace codewheel {

// The recorded traffic of a bus, with what it means: which a recording does not have, since it depends on the
// language. Made by its kind of bus, row by row.
class RecordedRows
{
public:
    using EncoderAt = std::function<const EncoderSession *(Place place)>; // null: it is not known

    virtual ~RecordedRows() = default;
    virtual std::span<const TrafficColumn> columns() const = 0;
    virtual bool areOfTerminal() const { return false; } // EncoderBus::hasTerminal()
    virtual TrafficRow explained(TrafficRow row, const EncoderAt &encoder) = 0;
    virtual void restart() = 0; // what comes does not follow what came
};

// Of the kind of bus that has encoders of these profiles. Where no kind has, such as on a bus whose devices
// are not in the catalog, what passed on it decides: words, or not.
std::unique_ptr<RecordedRows> recordedRows(std::span<const Profile> profiles, bool hasWords);

} // namespace codewheel
