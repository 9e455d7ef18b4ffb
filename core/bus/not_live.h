// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/freshness.h"
#include "vocabulary/place.h"

#include <QDateTime>

#include <optional>

namespace codewheel {

class EncoderBus;

// That what is shown or kept of a device is of before, and why; for what is put together once, a comparison
// or a report, and outlives the moment.
struct NotLive
{
    Freshness::Reason reason = Freshness::Reason::none;
    QDateTime seen{}; // last; not valid: never

    friend bool operator==(const NotLive &, const NotLive &) = default;
};

// Nothing: it is live, or this bus does not tell.
std::optional<NotLive> notLive(const EncoderBus &bus, Place place);

} // namespace codewheel
