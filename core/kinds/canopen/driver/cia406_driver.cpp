// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/driver/cia406_driver.h"

#include "kinds/canopen/protocol/canopen_messages.h"
#include "kinds/canopen/protocol/canopen_profile.h"
#include "kinds/canopen/protocol/canopen_reach.h"
#include "kinds/canopen/protocol/canopen_refusals.h"
#include "kinds/canopen/protocol/cob_id.h"
#include "kinds/canopen/protocol/device_profile.h"
#include "kinds/canopen/protocol/encoder_objects.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

namespace codewheel::canopen {
namespace {

constexpr int predefinedPdos = 4;
constexpr SdoObject heartbeatTime{0x1017, 0};

// TPDO1 with 6004h:0 in front.
PdoMapping usualMapping(int node)
{
    const std::uint32_t identifier = CobId{CobId::Service::tpdo, node, 1}.identifier();
    PdoMapping pdo(1);
    pdo.take({0x1800, 1},
             std::array{static_cast<std::uint8_t>(identifier), static_cast<std::uint8_t>(identifier >> 8)});
    pdo.take({0x1A00, 0}, std::array<std::uint8_t, 1>{1});
    pdo.take({0x1A00, 1}, std::array<std::uint8_t, 4>{0x20, 0x00, 0x04, 0x60});
    return pdo;
}

} // namespace

std::unique_ptr<NodeDriver> makeNodeDriver(const DeviceDescription &device, int node)
{
    return device.profile == profile::cia406 ? std::make_unique<Cia406Driver>(device, node) : nullptr;
}

Cia406Driver::Cia406Driver(const DeviceDescription &device, int node, const NodeTimes &settings)
    : m_encoder(device, node, settings)
{
    getToKnow();
}

// What it sends and when may have changed while it was away.
void Cia406Driver::getToKnow()
{
    m_pdos.clear();
    m_read.clear();
    m_heard.restarted(node());
    m_mute.reset();
    for (int number = 1; number <= predefinedPdos; ++number)
        m_pdos.emplace_back(number);
    m_isTypeAsked = false;
    m_toKnow = {object::deviceType, heartbeatTime};
    m_bits.clear();
    const auto reachOf = [this](Parameter parameter) {
        const ParameterDescription *its = m_encoder.device.find(parameter);
        return its != nullptr && its->canBeRead ? canopenReach(*its) : nullptr;
    };
    if (const CanopenReach *serial = reachOf(Parameter::serialNumber))
        m_toKnow.push_back(serial->object);
    std::ranges::copy(identifierObjects, std::back_inserter(m_toKnow));
    m_kept.clear();
    for (const Parameter parameter : {Parameter::alarms, Parameter::warnings})
        if (const CanopenReach *bits = reachOf(parameter))
            m_bits.push_back(bits->object);
    m_pdoAt.reset();
}

Result<void> Cia406Driver::begin(JobId id, const Job &job, Pace pace, Instant now)
{
    const bool mayStop = std::exchange(m_mayStop, false);
    if (m_job)
        return refuse(RefusalKind::busy, RefusalId::jobRunning);
    if (auto checked = m_encoder.plan().check(job); !checked)
        return checked;
    if (changesEncoder(job) && isOfOtherProfile(m_deviceType))
        return tl::unexpected(otherProfile());
    if (std::holds_alternative<ResetToDefault>(job) && m_encoder.mayRun() && !mayStop)
        return tl::unexpected(m_encoder.wouldStop());
    m_now = now;
    m_job.emplace(id, job, pace, mayStop, m_encoder);
    return {};
}

void Cia406Driver::proceed()
{
    if (m_job)
        m_job->proceed();
}

void Cia406Driver::cancel(OnCancel how, Instant now)
{
    if (!m_job)
        return;
    m_job->cancel(how, now);
    if (m_job->isDone())
        endJob();
}

void Cia406Driver::stop(const Refusal &why, Instant /*now*/)
{
    if (!m_job)
        return;
    m_job->stop(why);
    endJob();
    if (why.id == CanopenRefusalId::nodeDoubled)
        forgetValues(); // they may be of either
    m_encoder.flush();
}

// After that, an answer still awaited belongs to nobody.
void Cia406Driver::endJob()
{
    m_job.reset();
    if (m_asks == Asks::job)
        m_asks = Asks::nobody;
}

bool Cia406Driver::isPositionByPdo(Instant now) const
{
    return m_pdoAt && now - *m_pdoAt < m_encoder.settings.pdoPatience;
}

// A stopped node answers nothing, and one that was reset is waited for.
bool Cia406Driver::mayPoll() const
{
    return state() != NmtState::stopped && !mayBeSilent();
}

std::optional<Instant> Cia406Driver::wakesAt() const
{
    std::optional<Instant> wakes;
    const auto at = [&](std::optional<Instant> when) {
        if (when)
            wakes = std::min(wakes.value_or(*when), *when);
    };
    if (m_job && !m_job->waits())
        at(m_job->waitsUntil().value_or(m_now));
    at(m_encoder.watch.wakesAt(m_now));
    if (!mayPoll())
        return wakes;
    const bool isSilent = m_encoder.reading.state == EncoderState::silent;
    Instant due = toGetToKnow()            ? m_now
                  : isPositionByPdo(m_now) ? *m_pdoAt + m_encoder.settings.pdoPatience
                                           : m_positionDue;
    if (!m_bits.empty())
        due = std::min(due, m_bitsDue);
    at(isSilent ? std::max(due, m_silenceUntil) : due);
    return wakes;
}

// In turn, where both want something.
std::optional<NodeRequest> Cia406Driver::next(Instant now)
{
    m_now = now;
    if (m_encoder.watch.heartbeat(now) == Heartbeat::lost &&
        m_encoder.reading.state != EncoderState::silent && !mayBeSilent())
        fallSilent(now, 0);
    m_encoder.watch.setMayBeSilent(mayBeSilent(), now);
    if (auto request = m_wasPoll ? jobRequest(now) : pollRequest(now))
        return request;
    return m_wasPoll ? pollRequest(now) : jobRequest(now);
}

std::optional<NodeRequest> Cia406Driver::jobRequest(Instant now)
{
    if (!m_job || waitsForType())
        return std::nullopt;
    auto request = m_job->next(now);
    if (request) {
        m_asks = Asks::job;
        m_wasPoll = false;
    }
    if (m_job->isDone())
        endJob();
    return request;
}

std::optional<NodeRequest> Cia406Driver::pollRequest(Instant now)
{
    const auto object = mayPoll() ? polled(now) : std::nullopt;
    if (!object)
        return std::nullopt;
    m_asks = Asks::poll;
    m_wasPoll = true;
    m_isTypeAsked = m_isTypeAsked || *object == object::deviceType;
    return SdoRequest{.node = node(), .object = *object, .timeOut = m_encoder.settings.timeOut};
}

std::optional<SdoObject> Cia406Driver::polled(Instant now)
{
    if (m_encoder.reading.state == EncoderState::silent) {
        if (now < m_silenceUntil)
            return std::nullopt;
        m_silenceUntil = now + m_encoder.settings.silenceInterval;
    }
    if (m_mute) // whether it answers at all
        return object::position;
    if (const auto object = toGetToKnow())
        return object;
    if (now >= m_positionDue && !isPositionByPdo(now)) {
        m_positionDue = now + m_encoder.settings.positionInterval;
        return object::position;
    }
    if (now < m_bitsDue || m_bits.empty())
        return std::nullopt;
    m_bitsDue = now + m_encoder.settings.bitsInterval / static_cast<int>(m_bits.size());
    return m_bits[m_nextBits++ % m_bits.size()];
}

std::optional<SdoObject> Cia406Driver::toGetToKnow() const
{
    if (wantsType())
        return object::deviceType;
    for (const PdoMapping &pdo : m_pdos)
        if (const auto missing = pdo.missing(); !missing.empty())
            return missing.front();
    return m_toKnow.empty() ? std::nullopt : std::optional(m_toKnow.front());
}

void Cia406Driver::answered(const NodeRequest &request, const SdoOutcome &outcome, Instant now)
{
    m_now = now;
    const Asks asks = std::exchange(m_asks, Asks::nobody);
    if (std::holds_alternative<SdoRequest>(request))
        count(outcome, now);
    if (asks == Asks::poll)
        pollAnswered(std::get<SdoRequest>(request).object, outcome, now);
    if (asks == Asks::job) {
        m_job->answered(outcome, now);
        if (m_job->isDone())
            endJob();
    }
    m_encoder.flush();
}

void Cia406Driver::count(const SdoOutcome &outcome, Instant now)
{
    if (outcome.kind == SdoOutcome::Kind::notSent)
        return;
    if (outcome.kind != SdoOutcome::Kind::noAnswer) {
        if (m_encoder.reading.state == EncoderState::silent) {
            m_encoder.tell(now, Severity::information, MessageId::encoderAnswers);
            getToKnow();
        }
        m_unanswered = 0;
        m_encoder.isHeard(now);
        return;
    }
    const bool isSilent = m_encoder.reading.state == EncoderState::silent;
    if (++m_unanswered >= m_encoder.settings.silentAfter && !isSilent && !mayBeSilent())
        fallSilent(now, m_unanswered);
}

void Cia406Driver::fallSilent(Instant now, int tries)
{
    m_encoder.fallSilent();
    m_silenceUntil = now + m_encoder.settings.silenceInterval;
    m_encoder.tell(now, Severity::fault, MessageId::encoderSilent, {std::int64_t{tries}});
}

// What the encoder does not have is not asked for again, nor what it does not answer for while it answers for
// its position.
void Cia406Driver::pollAnswered(SdoObject object, const SdoOutcome &outcome, Instant now)
{
    using Kind = SdoOutcome::Kind;
    const bool isRead = outcome.kind == Kind::read;
    if (isRead)
        m_encoder.take(object, outcome, now);
    if (outcome.kind == Kind::noAnswer && toGetToKnow() == object)
        m_mute = object;
    if (!isRead && outcome.kind != Kind::aborted)
        return;
    if (const auto mute = std::exchange(m_mute, std::nullopt); mute && mute != object)
        gotToKnow(*mute, {}, now);
    if (toGetToKnow() == object)
        gotToKnow(object, outcome, now);
    else if (!isRead)
        std::erase(m_bits, object);
}

void Cia406Driver::gotToKnow(SdoObject object, const SdoOutcome &outcome, Instant now)
{
    if (std::ranges::any_of(m_pdos, [&](PdoMapping &each) { return each.take(object, outcome.value); })) {
        takeIdentifier(object, outcome, now);
        noteMappings();
        return;
    }
    std::erase(m_toKnow, object);
    if (object == object::deviceType)
        takeType(outcome, now);
    else if (object == heartbeatTime && !outcome.value.empty())
        m_encoder.watch.setProducerTime(std::chrono::milliseconds(numberOf(outcome.value)), now);
    else if (std::ranges::find(identifierObjects, object) != identifierObjects.end())
        takeIdentifier(object, outcome, now);
    else
        takeSerialNumber();
}

bool Cia406Driver::wantsType() const
{
    return std::ranges::count(m_toKnow, object::deviceType) != 0;
}

// Before anything is written.
bool Cia406Driver::waitsForType() const
{
    return m_job->changesEncoder() && wantsType() && !m_isTypeAsked && mayPoll() &&
           m_encoder.reading.state != EncoderState::silent;
}

void Cia406Driver::takeType(const SdoOutcome &outcome, Instant now)
{
    m_deviceType = outcome.value.empty() ? std::nullopt
                                         : std::optional(static_cast<std::uint32_t>(numberOf(outcome.value)));
    if (m_job && m_job->changesEncoder() && isOfOtherProfile(m_deviceType))
        stop(otherProfile(), now);
}

Refusal Cia406Driver::otherProfile() const
{
    return {RefusalKind::notSupported,
            CanopenRefusalId::otherProfile,
            {std::int64_t{node()}, std::int64_t{profileOf(*m_deviceType)}}};
}

void Cia406Driver::noteMappings()
{
    m_read.clear();
    std::ranges::copy_if(m_pdos, std::back_inserter(m_read),
                         [](const PdoMapping &pdo) { return pdo.isRead() && pdo.isThere() && !pdo.isOff(); });
    if (!std::ranges::all_of(m_pdos, &PdoMapping::isRead))
        return;
    std::vector<std::uint32_t> identifiers;
    for (const PdoMapping &pdo : m_read)
        if (!pdo.isExtended())
            identifiers.push_back(pdo.identifier());
    m_encoder.watch.setTpdos(std::move(identifiers));
}

void Cia406Driver::observe(const SdoRequest &request, const SdoOutcome &outcome, Instant now)
{
    using Kind = SdoOutcome::Kind;
    m_now = now;
    if (!request.value && outcome.kind == Kind::read)
        m_encoder.take(request.object, outcome, now);
    const bool mayBeDone =
        outcome.kind == Kind::written || outcome.kind == Kind::noAnswer || outcome.isOwnAbort;
    if (request.value && mayBeDone) {
        m_heard.restarted(node());
        noteWrite(request.object, outcome.kind == Kind::written);
    }
    m_encoder.flush();
}

// By somebody else. What follows from it is read again when it is needed.
void Cia406Driver::noteWrite(SdoObject object, bool isDone)
{
    constexpr int settingsIndex = 0x1800;
    constexpr int mappingIndex = 0x1A00;
    for (int number = 1; number <= predefinedPdos; ++number)
        if (object.index == settingsIndex + number - 1 || object.index == mappingIndex + number - 1) {
            m_pdos[static_cast<std::size_t>(number) - 1] = PdoMapping(number);
            m_pdoAt.reset();
            noteMappings();
        }
    if (object == heartbeatTime)
        m_toKnow.push_back(object);
    if (std::ranges::find(identifierObjects, object) != identifierObjects.end())
        m_toKnow.push_back(object);
    std::erase_if(m_kept, [object](const KeptIdentifier &each) { return each.object == object; });
    if (object == object::store && isDone)
        m_encoder.values.haveBeenStored();
    else if (object == object::store)
        m_encoder.values.mayHaveBeenStored();
    else if (object.index == object::restore.index)
        m_encoder.forgetWhatCanBeWritten();
    else
        m_encoder.mayHaveChanged(object);
}

// Another one than before: all that was known was of another encoder.
void Cia406Driver::takeSerialNumber()
{
    const auto number = m_encoder.values.value(Parameter::serialNumber);
    const auto before = std::exchange(m_serialNumber, number);
    if (number && before && before != number)
        forgetValues();
}

// It is told once, not at each boot-up.
void Cia406Driver::takeIdentifier(SdoObject object, const SdoOutcome &outcome, Instant now)
{
    std::erase_if(m_kept, [object](const KeptIdentifier &each) { return each.object == object; });
    if (outcome.value.empty())
        return;
    const auto kept = keptIdentifier(object, static_cast<std::uint32_t>(numberOf(outcome.value)), node());
    if (!kept)
        return;
    m_kept.push_back(*kept);
    if (std::ranges::find(m_keptTold, *kept) != m_keptTold.end())
        return;
    m_keptTold.push_back(*kept);
    Message message = kept->message();
    message.at = now;
    m_encoder.messages.push_back(std::move(message));
}

void Cia406Driver::forgetValues()
{
    for (const ParameterValue &value : m_encoder.values.values())
        if (value.parameter != Parameter::serialNumber)
            m_encoder.values.forget(value.parameter);
    m_encoder.takeCams({});
}

void Cia406Driver::take(const CanFrame &frame, Instant now)
{
    const auto booted = m_encoder.bootedAt;
    m_encoder.take(frame, now);
    if (m_encoder.bootedAt != booted) {
        getToKnow();
        m_unanswered = 0;
        if (m_job)
            m_job->nodeHasBooted();
        if (!mayBeSilent())
            m_encoder.tell(now, Severity::attention, CanopenMessageId::nodeBooted);
    }
    takePdo(frame, now);
}

// By another master, or by hand.
void Cia406Driver::hear(const SdoFrame &sdo)
{
    m_heard.followSdo(node(), sdo);
    if (sdo.isAnswer || (sdo.kind != SdoFrame::Kind::write && sdo.kind != SdoFrame::Kind::writeBegins))
        return;
    noteWrite(sdo.object, false);
    m_encoder.flush();
}

void Cia406Driver::takeUsualMapping()
{
    m_usual = usualMapping(node());
}

void Cia406Driver::takePdo(const CanFrame &frame, Instant now)
{
    bool isKnown = false;
    for (const PdoMapping &pdo : m_read)
        if (pdo.isOf(frame)) {
            takeValues(pdo, frame, now);
            isKnown = true;
        }
    if (isKnown)
        return;
    if (const auto heard = m_heard.of(frame))
        takeValues(heard->mapping, frame, now);
    else if (m_usual && m_usual->isOf(frame) && !m_heard.isElsewhere(node(), m_usual->number(), frame.id))
        takeValues(*m_usual, frame, now);
}

void Cia406Driver::takeValues(const PdoMapping &pdo, const CanFrame &frame, Instant now)
{
    const auto typeOf = [this](const SdoObject &object) { return m_encoder.pdoType(object); };
    for (const PdoValue &value : pdo.values(frame, typeOf)) {
        m_encoder.take(value, now);
        if (value.object == object::position)
            m_pdoAt = now;
    }
}

void Cia406Driver::lost(Instant /*now*/)
{
    m_encoder.reading.state = EncoderState::notSeen;
    m_encoder.watch = NodeWatch(node());
    m_encoder.forgetPosition();
    m_asks = Asks::nobody;
    m_unanswered = 0;
    m_deviceType.reset();
    m_keptTold.clear();
    getToKnow();
}

} // namespace codewheel::canopen
