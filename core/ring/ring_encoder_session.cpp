// SPDX-License-Identifier: GPL-3.0-or-later
#include "ring/ring_encoder_session.h"

#include "ring/bus_session.h"
#include "ring/job_report.h"
#include "ring/ring_runner.h"
#include "ring/send_permission.h"

#include <algorithm>

namespace codewheel {

RingEncoderSession::RingEncoderSession(BusSession &bus, std::size_t device, DeviceNumber number,
                                       const DeviceDescription &description, bool linkBoundsCycles)
    : m_bus(bus)
    , m_place(device)
    , m_number(number)
    , m_description(description)
    , m_linkBoundsCycles(linkBoundsCycles)
    , m_can(description.capabilities)
{
    m_can.manufacturerPreset = m_can.manufacturerPreset && linkBoundsCycles;
    connect(&bus, &BusSession::stateChanged, this, &EncoderSession::permissionChanged);
}

std::optional<Known> RingEncoderSession::known(Parameter parameter) const
{
    const auto found = m_known.find(parameter);
    return found == m_known.end() ? std::nullopt : std::optional(found->second);
}

QDateTime RingEncoderSession::dateTime(Instant at) const
{
    return m_bus.dateTime(at);
}

std::optional<KnownCams> RingEncoderSession::cams(unsigned program) const
{
    const auto found = m_cams.find(program);
    return found == m_cams.end() ? std::nullopt : std::optional(found->second);
}

void RingEncoderSession::tell(Parameter parameter, std::optional<std::int64_t> value)
{
    if (value)
        m_known[parameter] = {parameter, *value, Evidence::told, m_bus.latest().at};
    else if (m_known.erase(parameter) == 0)
        return;
    postKnown();
    Q_EMIT knownChanged();
}

void RingEncoderSession::postKnown()
{
    std::vector<Known> all;
    for (const auto &[parameter, known] : m_known)
        all.push_back(known);
    m_bus.post(command::SetKnown{m_place, std::move(all)});
}

Result<JobId> RingEncoderSession::start(const Job &job, Pace pace)
{
    if (m_runningJob)
        return refuse(RefusalKind::busy, RefusalId::jobRunning, {m_number.toString()});
    if (const auto allowed = maySend(m_bus.latest(), m_place, m_number, RefusalId::jobRunning); !allowed)
        return tl::unexpected(allowed.error());
    if (const auto allowed = checkLink(job); !allowed)
        return tl::unexpected(allowed.error());
    const JobId id = ++m_lastJob;
    m_runningJob = id;
    m_job = job;
    Q_EMIT jobAboutToStart(job);
    m_bus.post(command::StartJob{m_place, id, job, pace});
    Q_EMIT jobStarted(id);
    return id;
}

// 60000000h acts in every cycle in which it stands.
Result<void> RingEncoderSession::checkLink(const Job &job) const
{
    const bool mayBePreset = m_description.capabilities.manufacturerPreset || m_description.isGeneric();
    if (m_linkBoundsCycles || !mayBePreset)
        return {};
    const auto *preset = std::get_if<SetPreset>(&job);
    const auto *send = std::get_if<SendWords>(&job);
    const bool isPreset = preset != nullptr && preset->command == PresetCommand::manufacturer;
    const bool sends = send != nullptr && m_reading.mode != Mode::cam &&
                       std::ranges::find(send->words, k3::frabaPreset) != send->words.end();
    if (isPreset || sends)
        return refuse(RefusalKind::notSupported, RefusalId::linkDoesNotBoundCycles, {k3::frabaPreset});
    return {};
}

void RingEncoderSession::proceed()
{
    if (m_runningJob)
        m_bus.post(command::Proceed{m_place});
}

void RingEncoderSession::cancel(OnCancel how)
{
    if (m_runningJob)
        m_bus.post(command::Cancel{m_place, how});
}

void RingEncoderSession::show(const Reading &reading)
{
    const bool fresh = reading.at != m_reading.at || reading.state != m_reading.state;
    m_reading = reading;
    if (fresh)
        Q_EMIT latestChanged();
}

void RingEncoderSession::take(const Event &event, Instant at)
{
    if (const auto *outcome = std::get_if<Outcome>(&event))
        take(*outcome, at);
    else if (const auto *progress = std::get_if<Progress>(&event))
        Q_EMIT progressed(*progress);
    else
        take(std::get<KnowledgeChanged>(event));
}

void RingEncoderSession::take(const Outcome &outcome, Instant at)
{
    if (m_runningJob == outcome.job)
        m_runningJob.reset();
    for (Message &message : jobReport(m_job, outcome, m_description))
        report(std::move(message), at);
    Q_EMIT finished(outcome);
}

void RingEncoderSession::take(const KnowledgeChanged &change)
{
    for (const Known &known : change.known)
        m_known[known.parameter] = known;
    for (const Parameter parameter : change.noLongerKnown)
        m_known.erase(parameter);
    for (const KnownCams &known : change.cams)
        m_cams[known.program.number] = known;
    for (const unsigned program : change.camsNoLongerKnown)
        m_cams.erase(program);
    m_eepromWrites += change.eepromWrites;
    Q_EMIT knownChanged();
    if (change.eepromWrites > 0)
        Q_EMIT eepromWritten(change.eepromWrites);
}

// The number is 0 where the encoder has no valid position (80000000h).
Refusal RingEncoderSession::nameOf(const Message &fault) const
{
    const auto number = static_cast<unsigned>(std::get<std::int64_t>(fault.arguments.front()));
    const DeviceError *error = m_description.findError(number);
    if (number == 0)
        return {RefusalKind::device, RefusalId::noValidPosition, {}};
    return {RefusalKind::device, error ? error->meaning : RefusalId::otherDeviceError, {}};
}

void RingEncoderSession::takeFault(const Message &fault)
{
    if (nameOf(fault).id != RefusalId::parametersLost || m_known.empty())
        return;
    m_known.clear();
    m_cams.clear();
    postKnown();
    report({.severity = Severity::attention, .id = MessageId::valuesForgotten}, fault.at);
    Q_EMIT knownChanged();
}

void RingEncoderSession::report(Message message, Instant at)
{
    message.at = at;
    message.place = m_number;
    Q_EMIT m_bus.messaged(message);
}

} // namespace codewheel
