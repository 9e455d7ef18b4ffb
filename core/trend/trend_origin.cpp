// SPDX-License-Identifier: GPL-3.0-or-later
#include "trend/trend_origin.h"

#include "catalog/device_description.h"
#include "transfer/value_store.h"
#include "vocabulary/encoder_session.h"

namespace codewheel {

TrendEncoder trendEncoder(const EncoderSession &encoder)
{
    const DeviceDescription &device = encoder.device();
    return {.place = encoder.place(),
            .device = device.key,
            .deviceName = device.fullName(),
            .values = valuesToStore(encoder)};
}

} // namespace codewheel
