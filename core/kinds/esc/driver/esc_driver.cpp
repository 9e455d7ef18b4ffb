// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/driver/esc_driver.h"

#include "kinds/esc/protocol/esc_profile.h"

#include <algorithm>
#include <utility>

namespace codewheel {

std::unique_ptr<RequestDriver> makeRequestDriver(const DeviceDescription &device, EscLineAddress address)
{
    return device.profile == profile::esc ? std::make_unique<EscDriver>(device, address) : nullptr;
}

EscDriver::EscDriver(const DeviceDescription &device, EscLineAddress address, EscSettings settings)
    : m_encoder(device, address, settings)
    , m_polls(settings)
{}

void EscDriver::setSettings(const EscSettings &settings)
{
    m_encoder.settings = settings;
    m_polls.setSettings(settings);
}

void EscDriver::setLineBaudRate(int baudRate)
{
    m_encoder.baudRate = baudRate;
    if (m_encoder.wantedBaudRate == baudRate)
        m_encoder.wantedBaudRate.reset();
}

Result<void> EscDriver::begin(JobId id, const Job &job, Pace pace, Instant now)
{
    if (m_job)
        return refuse(RefusalKind::busy, RefusalId::jobRunning);
    if (auto checked = m_encoder.plan().check(job); !checked)
        return checked;
    m_job.emplace(id, job, pace, m_encoder);
    m_now = m_confirmed = now;
    return {};
}

void EscDriver::proceed()
{
    if (!m_job)
        return;
    m_job->proceed();
    m_confirmed = m_now;
}

void EscDriver::cancel(OnCancel how, Instant now)
{
    if (!m_job)
        return;
    m_job->cancel(how, now);
    if (m_job->isDone())
        endJob();
}

void EscDriver::stop(const Refusal &why, Instant)
{
    if (!m_job)
        return;
    m_job->stop(why);
    endJob();
}

// After that, an answer still awaited belongs to nobody.
void EscDriver::endJob()
{
    m_job.reset();
    if (m_asks == Asks::job)
        m_asks = Asks::nobody;
}

std::optional<Instant> EscDriver::wakesAt() const
{
    if (m_job && !m_job->waits())
        return m_now;
    return m_polls.wakesAt(m_now);
}

std::optional<esc::Request> EscDriver::next(Instant now)
{
    m_now = now;
    if (m_job && m_job->isSearching())
        return other(now);
    if (!m_wasPosition)
        if (auto request = position(now))
            return request;
    if (auto request = other(now))
        return request;
    return position(now);
}

std::optional<esc::Request> EscDriver::position(Instant now)
{
    if (!m_polls.isPositionDue(now))
        return std::nullopt;
    m_polls.positionAsked(now);
    m_asks = Asks::position;
    m_wasPosition = true;
    return esc::Request{m_encoder.address, esc::Command::position};
}

std::optional<esc::Request> EscDriver::other(Instant now)
{
    std::optional<esc::Request> request;
    if (m_job) {
        request = m_job->next(now);
        m_asks = request ? Asks::job : Asks::nobody;
        if (m_job->isDone())
            endJob();
    }
    if (!request) {
        if (const auto command = m_polls.between(now)) {
            request = {m_encoder.address, *command};
            m_asks = Asks::between;
        }
    }
    m_wasPosition = m_wasPosition && !request;
    return request;
}

void EscDriver::answered(const esc::Request &request, const esc::ExchangeResult &result, Instant now)
{
    m_now = now;
    const Asks asks = std::exchange(m_asks, Asks::nobody);
    const bool isTooLate = isJobTooLate(result, now);
    count(result, now);
    switch (asks) {
    case Asks::nobody:
        observe(request, result, now);
        break;
    case Asks::position:
        positionAnswered(result, now);
        break;
    case Asks::between:
        betweenAnswered(request.command, result, now);
        break;
    case Asks::job:
        m_job->answered(result, now);
        if (m_job->isDone())
            endJob();
        break;
    }
    if (isTooLate && m_job && m_job->hasYetToWrite()) {
        m_job->endUnsent(m_encoder.settings.jobPatience);
        endJob();
    }
    m_encoder.flushKnowledge();
}

// Whoever confirmed a job saw the encoder as it was then. A preset is for one place of the shaft, so for it
// any wait counts.
bool EscDriver::isJobTooLate(const esc::ExchangeResult &result, Instant now) const
{
    const bool isLong = now - std::max(m_confirmed, m_answered) > m_encoder.settings.jobPatience;
    const bool isUnanswered = m_unanswered > 0 || !result.answer;
    return isLong && m_job && (isUnanswered || m_job->isPreset());
}

// Silence and its end. A request to another place than the encoder's says nothing about the encoder.
void EscDriver::count(const esc::ExchangeResult &result, Instant now)
{
    if (m_job && m_job->isSearching())
        return;
    if (result.answer) {
        m_answered = now;
        if (m_encoder.reading.state == EncoderState::silent)
            m_encoder.tell(now, Severity::information, MessageId::encoderAnswers);
        m_unanswered = m_tries = 0;
        if (!m_polls.isInContact())
            contact(now);
        return;
    }
    ++m_unanswered;
    m_tries += result.sent;
    if (m_unanswered < m_encoder.settings.silentAfter || m_encoder.reading.state == EncoderState::silent)
        return;
    m_encoder.reading.state = EncoderState::silent;
    m_encoder.reading.suspect = false;
    m_encoder.forgetPosition();
    m_polls.silence(now);
    m_encoder.tell(now, Severity::fault, MessageId::encoderSilent, {std::int64_t{m_tries}});
}

// Neither silence nor its end: it is the line that has something to report.
void EscDriver::lost(Instant now)
{
    m_encoder.reading.state = EncoderState::notSeen;
    m_encoder.reading.suspect = false;
    m_encoder.forgetPosition();
    m_polls.silence(now);
    m_unanswered = m_tries = 0;
    m_asks = Asks::nobody;
}

void EscDriver::contact(Instant now)
{
    m_encoder.reading.state = EncoderState::operation;
    m_between = EscAgreement(m_encoder.settings.readTries);
    m_polls.contact(now);
    m_encoder.values.forget(Parameter::serialNumber); // until it is read again: it may be another encoder
    if (m_encoder.address.isDevice())
        m_encoder.values.learn({Parameter::lineAddress, m_encoder.address.value, Evidence::read, now});
    const auto baudRate = m_encoder.wantedBaudRate ? m_encoder.wantedBaudRate : m_encoder.baudRate;
    if (baudRate)
        m_encoder.values.learn({Parameter::baudRate, *baudRate, Evidence::read, now});
}

void EscDriver::positionAnswered(const esc::ExchangeResult &result, Instant now)
{
    if (hasValue(result.answer) && !m_encoder.takePosition(result.answer->value, now))
        m_polls.askPositionAgain();
}

// Warnings and alarms that have not changed need no second read.
void EscDriver::betweenAnswered(esc::Command command, const esc::ExchangeResult &result, Instant now)
{
    if (!m_polls.isInContact() || m_polls.between(now) != command)
        return;
    if (!result.answer) {
        m_polls.putOff();
    } else {
        switch (m_between.add(*result.answer)) {
        case EscAgreement::State::wantsMore:
            if (!hasValue(result.answer) || !m_encoder.saysTheSame(command, *result.answer))
                return;
            m_polls.betweenDone();
            break;
        case EscAgreement::State::agreed:
            // 03 twice: the encoder does not know the command, and never will.
            if (hasValue(result.answer))
                betweenAgreed(command, *result.answer, now);
            m_polls.betweenDone();
            break;
        case EscAgreement::State::disagreed:
            m_polls.putOff();
            break;
        }
    }
    m_between = EscAgreement(m_encoder.settings.readTries);
}

// A serial number other than before: everything known was about another encoder.
void EscDriver::betweenAgreed(esc::Command command, const esc::Answer &answer, Instant now)
{
    if (command == esc::Command::serialNumber) {
        const auto before = std::exchange(m_serialNumber, std::int64_t{answer.value});
        if (before && before != m_serialNumber)
            for (const ParameterValue &value : m_encoder.values.values())
                if (value.parameter != Parameter::lineAddress && value.parameter != Parameter::baudRate)
                    m_encoder.values.forget(value.parameter);
    }
    m_encoder.take(command, answer, now);
}

void EscDriver::observe(const esc::Request &request, const esc::ExchangeResult &result, Instant)
{
    if (!esc::shapeOf(request.command).writes || result.sent == 0)
        return;
    const bool isAccepted = result.answer && result.answer->kind == esc::Answer::Kind::accepted;
    if (result.answer && !isAccepted)
        return;
    m_encoder.mayHaveChanged(request.command);
    m_encoder.values.countEepromWrite();
    m_encoder.flushKnowledge();
}

} // namespace codewheel
