// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/encoder_on_bus.h"

#include "bus/encoder_bus.h"
#include "jobs/values_to_write.h"

#include <utility>

namespace codewheel {

EncoderOnBus::EncoderOnBus(EncoderBus &bus, std::size_t device, Place place,
                           const DeviceDescription &description)
    : DrivenEncoderSession(device, place, description)
    , m_ofBus(bus)
{
    connect(&bus, &EncoderBus::stateChanged, this, &EncoderSession::permissionChanged);
}

QDateTime EncoderOnBus::dateTime(Instant at) const
{
    return m_ofBus.dateTime(at);
}

Result<std::vector<Step>> EncoderOnBus::planned(const std::vector<Job> &jobs) const
{
    return stepsForJobs(*this, jobs, Word{});
}

void EncoderOnBus::report(Message message, Instant at)
{
    message.at = at;
    message.place = place();
    m_ofBus.tell(std::move(message));
}

Instant EncoderOnBus::now() const
{
    return m_ofBus.now();
}

Instant EncoderOnBus::instantOf(const QDateTime &time) const
{
    return m_ofBus.instantOf(time);
}

} // namespace codewheel
