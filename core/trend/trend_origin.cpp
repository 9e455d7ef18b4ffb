// SPDX-License-Identifier: GPL-3.0-or-later
#include "trend/trend_origin.h"

#include "catalog/device_description.h"
#include "encoder/encoder_session.h"
#include "transfer/value_store.h"

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
