// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/traffic.h"
#include "can/frame_meaning.h"
#include "kinds/canopen/bus/canopen_event.h"

#include <array>
#include <memory>

namespace codewheel {

class RecordedRows;

// What passes on a CAN bus with CANopen, as rows.

inline constexpr std::array canTrafficColumns{TrafficColumn::time,       TrafficColumn::direction,
                                              TrafficColumn::identifier, TrafficColumn::who,
                                              TrafficColumn::bytes,      TrafficColumn::meaning};

// A frame as rows keep it, from which it can be read again: four octets as in captures of SocketCAN, the
// identifier with its flags, the highest first; then its data, or, of a remote frame, how much it asks for.
QByteArray frameBytes(const CanFrame &frame);
std::optional<CanFrame> canFrameOf(const QByteArray &bytes);

// The rows of one bus: what they mean follows from those before.
class CanopenTraffic
{
public:
    TrafficRow row(const CanopenRow &passed, Instant at);

private:
    CanFrameMeanings m_meanings;
};

std::unique_ptr<RecordedRows> makeCanopenRows(); // the same of a recording

} // namespace codewheel
