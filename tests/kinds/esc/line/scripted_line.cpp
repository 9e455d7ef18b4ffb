// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/kinds/esc/line/scripted_line.h"

#include <algorithm>

namespace codewheel {
namespace {

constexpr Instant betweenChatter{50'000};

} // namespace

Result<void> ScriptedLink::open(const SerialSettings &settings)
{
    ++tries;
    if (unplugged)
        return refuse(RefusalKind::link, RefusalId::portNotFound, {name()});
    if (isOther)
        return refuse(RefusalKind::link, RefusalId::portOfOther, {name(), QStringLiteral("ours")});
    ++opened;
    m_baudRate = settings.baudRate;
    m_coming.clear();
    while (talk && talk->at < m_now)
        takeTalk();
    return {};
}

QByteArray ScriptedLink::takeTalk()
{
    QByteArray bytes = talk->bytes;
    talk->at += talk->every;
    if (talk->every == Instant{})
        talk.reset();
    return bytes;
}

Result<void> ScriptedLink::setBaudRate(int baudRate)
{
    m_baudRate = baudRate;
    return {};
}

Result<void> ScriptedLink::write(const QByteArray &bytes)
{
    if (unplugged)
        return refuse(RefusalKind::link, RefusalId::portLost, {name()});
    sent.push_back({m_now, m_baudRate, bytes});
    if (echoes)
        m_coming.push_back({m_now, bytes});
    const auto found = answers.find(bytes);
    if (found != answers.end() && m_baudRate == answersAt.value_or(m_baudRate))
        m_coming.push_back({m_now + delay, found->second});
    return {};
}

Result<QByteArray> ScriptedLink::read(Instant until)
{
    if (unplugged) {
        m_now = std::max(m_now, until);
        return refuse(RefusalKind::link, RefusalId::portLost, {name()});
    }
    if (!chatter.isEmpty()) {
        m_now = std::min(until, m_now + betweenChatter);
        return chatter;
    }
    if (talk && talk->at <= until && (m_coming.empty() || talk->at <= m_coming.front().at)) {
        m_now = std::max(m_now, talk->at);
        return takeTalk();
    }
    if (m_coming.empty() || m_coming.front().at > until) {
        m_now = std::max(m_now, until);
        return QByteArray();
    }
    const Coming first = m_coming.front();
    m_coming.pop_front();
    m_now = std::max(m_now, first.at) + readsLate;
    return first.bytes;
}

std::vector<QByteArray> ScriptedLink::sentTexts() const
{
    std::vector<QByteArray> texts;
    for (const Sent &one : sent)
        texts.push_back(one.bytes.mid(1, one.bytes.size() - 3));
    return texts;
}

Result<void> PollingDriver::begin(JobId id, const Job &, Pace, Instant)
{
    m_job = id;
    return {};
}

void PollingDriver::stop(const Refusal &why, Instant)
{
    Outcome outcome;
    outcome.job = *m_job;
    outcome.result = tl::unexpected(why);
    m_job.reset();
    m_events.emplace_back(std::move(outcome));
}

std::optional<esc::Request> PollingDriver::next(Instant now)
{
    m_wakesAt = now + m_period;
    return esc::Request{.to = m_address, .command = esc::Command::position};
}

void PollingDriver::answered(const esc::Request &, const esc::ExchangeResult &result, Instant now)
{
    m_reading.at = now;
    m_reading.state = result.answer ? EncoderState::operation : EncoderState::silent;
    if (result.answer)
        m_reading.position = result.answer->value;
}

} // namespace codewheel
