// SPDX-License-Identifier: GPL-3.0-or-later
#include "transfer/new_encoder.h"

#include "bus/encoder_bus.h"
#include "bus/word_channel.h"
#include "jobs/values_to_write.h"

#include <utility>

namespace codewheel {
namespace {

// Its state and its word can be seen; what the word means depends on values that nobody knows.
Reading seenOnly(Reading reading)
{
    reading.position.reset();
    reading.stepsPerSecond.reset();
    reading.velocity.reset();
    reading.cams.reset();
    reading.mode.reset();
    reading.camProgram.reset();
    reading.coding.reset();
    return reading;
}

} // namespace

NewEncoder::NewEncoder(const EncoderBus &bus, Place place, DeviceDescription description)
    : m_bus(bus)
    , m_place(place)
    , m_description(std::move(description))
    , m_reading(seenOnly(bus.encoder(place)->latest()))
{}

KindData NewEncoder::valueOptions() const
{
    return valueOptionsOf(m_bus.encoder(m_place));
}

Result<std::vector<Step>> NewEncoder::planned(const std::vector<Job> &jobs) const
{
    const WordChannel *channel = m_bus.channel(m_place);
    return stepsForJobs(*this, jobs, channel ? channel->out() : 0);
}

Result<JobId> NewEncoder::start(const Job & /*job*/, Pace /*pace*/)
{
    return refuse(RefusalKind::notSupported, RefusalId::writingNotSupported, {m_description.fullName()});
}

QDateTime NewEncoder::dateTime(Instant at) const
{
    return m_bus.dateTime(at);
}

} // namespace codewheel
