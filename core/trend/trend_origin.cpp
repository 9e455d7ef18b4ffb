// SPDX-License-Identifier: GPL-3.0-or-later
#include "trend/trend_origin.h"

#include "catalog/device_description.h"
#include "transfer/value_store.h"
#include "vocabulary/encoder_session.h"

namespace codewheel {

namespace {

std::vector<TrendValue> valuesNow(const EncoderSession &encoder)
{
    std::vector<TrendValue> values;
    for (const StoredValue &value : valuesToStore(encoder))
        values.push_back({value.parameter, value.value, value.evidence, value.at});
    return values;
}

// Of the newest of them.
Instant sameSince(const std::vector<ValuesSince> &known, const ParameterValue &value)
{
    Instant since = known.back().from;
    for (auto one = known.rbegin();
         one != known.rend() && findValue(one->values, value.parameter) == value.value; ++one)
        since = one->from;
    return since;
}

} // namespace

std::vector<TrendValue> recordedValues(const std::vector<ValuesSince> &known)
{
    std::vector<TrendValue> values;
    if (known.empty())
        return values;
    for (const ParameterValue &value : known.back().values) {
        const auto since = std::chrono::floor<std::chrono::milliseconds>(sameSince(known, value));
        values.push_back({.parameter = value.parameter,
                          .value = value.value,
                          .at = QDateTime::fromMSecsSinceEpoch(since.count(), Qt::UTC)});
    }
    return values;
}

TrendEncoder trendEncoder(const EncoderSession &encoder)
{
    const DeviceDescription &device = encoder.device();
    return {.place = encoder.place(),
            .device = device.key,
            .deviceName = device.fullName(),
            .values = valuesNow(encoder)};
}

} // namespace codewheel
