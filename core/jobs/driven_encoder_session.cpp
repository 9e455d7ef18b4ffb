// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/driven_encoder_session.h"

#include "catalog/kept_values.h"
#include "jobs/job_report.h"
#include "jobs/value_notes.h"
#include "jobs/values_to_write.h"
#include "vocabulary/position_speed.h"

#include <algorithm>
#include <utility>

namespace codewheel {
namespace {

// What a word means may become known later, and changes nothing.
bool showsTheSame(const DeviceDescription &device, const Reading &before, const Reading &now)
{
    const bool isSeen = before.state != EncoderState::notSeen;
    return device.hasWords() ? isSeen && before.in == now.in
                             : before.state == now.state && before.position == now.position;
}

// A later job that only may have cost a write leaves what an earlier one has left in doubt.
bool concernsMoreThanWrites(const InDoubt &doubt)
{
    return doubt != InDoubt{.eepromWrites = doubt.eepromWrites};
}

// What it was given, not which encoder it is.
bool isGivenValue(const std::pair<const Parameter, Known> &one)
{
    return one.first != Parameter::serialNumber;
}

} // namespace

DrivenEncoderSession::DrivenEncoderSession(std::size_t device, Place place,
                                           const DeviceDescription &description)
    : m_index(device)
    , m_place(place)
    , m_description(description)
    , m_can(description.capabilities)
{}

std::optional<Known> DrivenEncoderSession::known(Parameter parameter) const
{
    const auto found = m_known.find(parameter);
    return found == m_known.end() ? std::nullopt : std::optional(found->second);
}

std::optional<KnownCams> DrivenEncoderSession::cams(unsigned program) const
{
    const auto found = m_cams.find(program);
    return found == m_cams.end() ? std::nullopt : std::optional(found->second);
}

void DrivenEncoderSession::tell(Parameter parameter, const std::optional<Value> &value)
{
    if (value)
        m_known[parameter] = withKept({parameter, *value, Evidence::told, now()});
    else if (m_known.erase(parameter) == 0)
        return;
    postAllKnown();
    Q_EMIT knownChanged();
}

Known DrivenEncoderSession::withKept(Known known) const
{
    known.kept = keptOf(m_description, known.parameter, known.kept);
    return known;
}

void DrivenEncoderSession::postAllKnown()
{
    std::vector<Known> all;
    for (const auto &[parameter, known] : m_known)
        all.push_back(known);
    post(command::SetKnown{m_index, std::move(all)});
}

Result<JobId> DrivenEncoderSession::start(const Job &job, Pace pace)
{
    if (m_runningJob)
        return refuse(RefusalKind::busy, RefusalId::jobRunning, {m_place.shown()});
    if (const auto allowed = mayStart(job); !allowed)
        return tl::unexpected(allowed.error());
    const JobId id = ++m_lastJob;
    m_runningJob = id;
    m_job = job;
    Q_EMIT jobAboutToStart(job);
    post(command::StartJob{m_index, id, job, pace});
    Q_EMIT jobStarted(id);
    return id;
}

void DrivenEncoderSession::proceed()
{
    if (m_runningJob)
        post(command::Proceed{m_index});
}

void DrivenEncoderSession::cancel(OnCancel how)
{
    if (!m_runningJob)
        return;
    if (how == OnCancel::restorePrevious)
        Q_EMIT restoreAboutToStart();
    post(command::Cancel{m_index, how});
}

void DrivenEncoderSession::show(const Reading &reading, const Freshness::Circumstances &bus)
{
    const Reading before = std::exchange(m_reading, reading);
    setFreshness({reading, bus});
    if (!freshness().isLive())
        m_unchangedSince.reset(); // what came meanwhile was not seen
    else if (!m_unchangedSince || !showsTheSame(m_description, before, reading))
        m_unchangedSince = reading.at;
    if (freshness().isLive() && reading.state == EncoderState::operation && reading.at > m_takenAt)
        m_taken = {};
    if (reading.mode == Mode::position && reading.at > m_leftAt)
        m_leftInMode.reset();
    if (!freshness().isLive() || bus.now - reading.at > PositionSpeed::longestGap)
        m_reading.stepsPerSecond.reset();
    const bool isNewer = reading.at != before.at || reading.state != before.state;
    if (isNewer || m_reading.stepsPerSecond != before.stepsPerSecond)
        Q_EMIT latestChanged();
}

void DrivenEncoderSession::take(const Event &event, Instant at)
{
    if (const auto *outcome = std::get_if<Outcome>(&event))
        take(*outcome, at);
    else if (const auto *progress = std::get_if<Progress>(&event))
        Q_EMIT progressed(*progress);
    else if (const auto *doubt = std::get_if<InDoubt>(&event))
        take(*doubt, at);
    else
        take(std::get<KnowledgeChanged>(event));
}

void DrivenEncoderSession::take(const Outcome &outcome, Instant at)
{
    if (m_runningJob == outcome.job)
        m_runningJob.reset();
    if (concernsMoreThanWrites(outcome.inDoubt))
        m_inDoubt = outcome.inDoubt;
    takeWhatWaitsForRun(outcome, at);
    takeModeLeft(outcome, at);
    for (Message &message : jobReport(m_job, outcome, m_description, valuesOf(allKnown(*this))))
        report(std::move(message), at);
    Q_EMIT finished(outcome);
}

void DrivenEncoderSession::take(const InDoubt &doubt, Instant at)
{
    m_inDoubt = doubt;
    noteTaken(doubt.values, doubt.reset, at);
    for (Message &message : doubtReport(doubt, m_description))
        report(std::move(message), at);
}

// Another mode that was asked for is not left behind.
void DrivenEncoderSession::takeModeLeft(const Outcome &outcome, Instant at)
{
    if (outcome.result && std::holds_alternative<SwitchMode>(m_job))
        m_leftInMode.reset();
    if (!outcome.leftInMode || outcome.leftInMode->mode == Mode::position)
        return;
    m_leftInMode = outcome.leftInMode;
    m_leftAt = at;
}

void DrivenEncoderSession::takeWhatWaitsForRun(const Outcome &outcome, Instant at)
{
    noteTaken(outcome.confirmed, outcome.resetWaits, at);
    noteTaken(outcome.inDoubt.values, outcome.inDoubt.reset, at);
    for (const unsigned program : outcome.inDoubt.camPrograms)
        if (std::ranges::count(m_taken.camPrograms, program) == 0)
            m_taken.camPrograms.push_back(program);
}

void DrivenEncoderSession::noteTaken(const ParameterValues &values, bool reset, Instant at)
{
    for (const ParameterValue &value : values)
        replaceValue(m_taken.values, value);
    m_taken.reset = m_taken.reset || reset;
    m_takenAt = at;
}

QString DrivenEncoderSession::takenWithoutRun() const
{
    return doubtText(m_taken, m_description);
}

bool DrivenEncoderSession::hasTakenCams() const
{
    return !m_taken.camPrograms.empty() && m_taken == InDoubt{.camPrograms = m_taken.camPrograms};
}

std::vector<Parameter> DrivenEncoderSession::readableDoubts() const
{
    std::vector<Parameter> parameters;
    for (const ParameterDescription &its : m_description.parameters) {
        const bool isValue =
            its.canBeWritten && (m_inDoubt.reset || findValue(m_inDoubt.values, its.parameter));
        const bool isOfPosition = m_inDoubt.position && its.parameter == Parameter::zeroOffset;
        if (its.canBeRead && (isValue || isOfPosition) && !known(its.parameter))
            parameters.push_back(its.parameter);
    }
    return parameters;
}

void DrivenEncoderSession::take(const KnowledgeChanged &change)
{
    for (const Known &known : change.known)
        m_known[known.parameter] = withKept(known);
    for (const Parameter parameter : change.noLongerKnown)
        m_known.erase(parameter);
    for (const KnownCams &known : change.cams)
        m_cams[known.program.number] = known;
    for (const unsigned program : change.camsNoLongerKnown)
        m_cams.erase(program);
    if (!change.version.isEmpty())
        m_version = change.version;
    m_eepromWrites += change.eepromWrites;
    compareWithBefore();
    Q_EMIT knownChanged();
    if (change.eepromWrites > 0)
        Q_EMIT eepromWritten(change.eepromWrites);
}

// By the serial number that it has just reported.
void DrivenEncoderSession::compareWithBefore()
{
    const auto number = reportedSerialNumber(*this);
    if (!knownBefore() || !knownBefore()->serialNumber || !number)
        return;
    if (number == knownBefore()->serialNumber)
        takeKnownBefore();
    else
        setKnownBefore({});
}

void DrivenEncoderSession::takeOver(const KnownBefore &before)
{
    for (const KnownBefore::Entry &value : before.values) {
        const Instant at = instantOf(value.at);
        m_known.try_emplace(value.parameter,
                            withKept({value.parameter, value.value, value.evidence, at, value.kept}));
    }
    if (before.serialNumber && !before.values.empty()) {
        const Instant at =
            instantOf(std::ranges::max_element(before.values, {}, &KnownBefore::Entry::at)->at);
        m_known.try_emplace(Parameter::serialNumber,
                            Known{Parameter::serialNumber, *before.serialNumber, Evidence::read, at});
    }
    postAllKnown();
}

bool DrivenEncoderSession::knowsValues() const
{
    return std::ranges::any_of(m_known, isGivenValue);
}

void DrivenEncoderSession::forgetValues()
{
    setKnownBefore({});
    std::erase_if(m_known, isGivenValue);
    m_cams.clear();
    postAllKnown();
}

void DrivenEncoderSession::forgetWhatWasNotStored()
{
    std::erase_if(m_known,
                  [](const auto &one) { return isGivenValue(one) && one.second.kept != Kept::stored; });
    m_cams.clear();
    postAllKnown();
    Q_EMIT knownChanged();
}

void DrivenEncoderSession::forgetKnown()
{
    m_known.clear();
    m_cams.clear();
    m_leftInMode.reset();
    postAllKnown();
}

} // namespace codewheel
