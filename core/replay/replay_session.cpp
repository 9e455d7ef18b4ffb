// SPDX-License-Identifier: GPL-3.0-or-later
#include "replay/replay_session.h"

#include "jobs/protocol.h"
#include "replay/replay_bus.h"

#include <utility>

namespace codewheel {
namespace {

Capabilities nothing()
{
    Capabilities can;
    can.readingHidesPosition = false;
    return can;
}

Reading unexplained(Word in)
{
    Reading reading;
    reading.state = EncoderState::unknown;
    reading.in = in;
    return reading;
}

} // namespace

ReplayEncoderSession::ReplayEncoderSession(const ReplayBus &bus, Place place, DeviceDescription device)
    : m_bus(bus)
    , m_place(place)
    , m_device(std::move(device))
    , m_can(nothing())
{}

std::optional<Known> ReplayEncoderSession::known(Parameter parameter) const
{
    if (const auto told = m_told.find(parameter); told != m_told.end())
        return Known{parameter, told->second, Evidence::told, m_reading.at};
    const auto value = findValue(m_known, parameter);
    return value ? std::optional(Known{parameter, *value, Evidence::told, m_knownSince}) : std::nullopt;
}

std::vector<Known> ReplayEncoderSession::allKnown() const
{
    std::vector<Known> all;
    for (const Parameter parameter : allParameters())
        if (const auto one = known(parameter))
            all.push_back(*one);
    return all;
}

void ReplayEncoderSession::tell(Parameter parameter, const std::optional<Value> &value)
{
    if (value)
        m_told.insert_or_assign(parameter, *value);
    else
        m_told.erase(parameter);
    Q_EMIT knownChanged();
}

Result<std::vector<Step>> ReplayEncoderSession::planned(const std::vector<Job> &) const
{
    return tl::unexpected(onlyRecorded());
}

Result<JobId> ReplayEncoderSession::start(const Job &, Pace)
{
    return tl::unexpected(onlyRecorded());
}

QDateTime ReplayEncoderSession::dateTime(Instant at) const
{
    return m_bus.dateTime(at);
}

void ReplayEncoderSession::show(const RecordedEncoder::Moment &moment, Instant at,
                                const RecordedEncoder::Described &described)
{
    const ParameterValues before = std::exchange(m_known, described.device.known);
    m_knownSince = described.since;
    if (m_known != before)
        Q_EMIT knownChanged();
    const Reading was = std::exchange(m_reading, readingOf(moment, at));
    setFreshness(Freshness::ofRecording(moment.isKnown() ? std::optional(at) : std::nullopt));
    if (m_reading != was)
        Q_EMIT latestChanged();
}

// What a driver would say of the words alone; its position depends on what it had seen before, so the
// recorded one counts.
Reading ReplayEncoderSession::readingOf(const RecordedEncoder::Moment &moment, Instant at) const
{
    const auto &in = moment.of(Channel::in);
    const auto &out = moment.of(Channel::out);
    Reading reading =
        in ? ofWords(static_cast<Word>(*in), static_cast<Word>(out.value_or(0)), at) : Reading();
    reading.at = at;
    reading.position = moment.of(Channel::position);
    reading.velocity.reset();
    reading.stepsPerSecond.reset();
    reading.cams.reset();
    if (const auto &speed = moment.of(Channel::speed))
        reading.stepsPerSecond = static_cast<double>(*speed) / speedUnits;
    if (const auto &cams = moment.of(Channel::cams))
        reading.cams = {static_cast<std::uint8_t>(*cams),
                        in ? protocolOf(m_device).positionBesideCams(static_cast<Word>(*in)) : 0};
    if (!in && (reading.position || reading.cams))
        reading.state = EncoderState::operation;
    if (reading.cams)
        reading.mode = Mode::cam;
    else if (reading.position && m_device.quirks.hasModes)
        reading.mode = Mode::position;
    return reading;
}

Reading ReplayEncoderSession::ofWords(Word in, Word out, Instant at) const
{
    return protocolOf(m_device).readingOf(m_device, allKnown(), in, out, at).value_or(unexplained(in));
}

} // namespace codewheel
