// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "replay/recorded_rows.h"

namespace codewheel::test {

inline constexpr std::array plainColumns{TrafficColumn::time,      TrafficColumn::sinceLast,
                                         TrafficColumn::direction, TrafficColumn::bytes,
                                         TrafficColumn::meaning,   TrafficColumn::remark};

// What a line says, to the encoder or from it: "Filter := -5, Device name := Hoist"; empty: it is none.
QString plainMeaning(const DeviceDescription &device, const QByteArray &line);

std::unique_ptr<RecordedRows> makePlainRows();

} // namespace codewheel::test
