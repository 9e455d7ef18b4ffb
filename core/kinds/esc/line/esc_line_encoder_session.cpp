// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/line/esc_line_encoder_session.h"

#include "kinds/esc/line/esc_line_permission.h"
#include "kinds/esc/line/esc_line_session.h"

namespace codewheel {

EscEncoderSession::EscEncoderSession(EscLineSession &line, std::size_t device, EscLineAddress address,
                                     const DeviceDescription &description)
    : DrivenEncoderSession(device, line.placeOf(address.node()), description)
    , m_line(line)
{
    connect(&line, &EscLineSession::stateChanged, this, &EncoderSession::permissionChanged);
}

QDateTime EscEncoderSession::dateTime(Instant at) const
{
    return m_line.dateTime(at);
}

Result<std::vector<Step>> EscEncoderSession::planned(const std::vector<Job> &jobs) const
{
    for (const Job &job : jobs)
        if (const auto checked = checkAddress(job); !checked)
            return tl::unexpected(checked.error());
    return stepsForJobs(*this, jobs, Word{});
}

// The driver checks it once more: by then another encoder may have come.
Result<void> EscEncoderSession::checkAddress(const Job &job) const
{
    const auto *write = std::get_if<WriteParameters>(&job);
    const auto wanted = write != nullptr ? valueOf(write->values, Parameter::lineAddress) : std::nullopt;
    if (!wanted)
        return {};
    if (auto taken =
            m_line.addressTaken({static_cast<std::uint8_t>(*wanted)}, EscLineAddress::of(place().node)))
        return tl::unexpected(*std::move(taken));
    return {};
}

int EscEncoderSession::fractionBits() const
{
    return m_line.fractionBits();
}

Result<void> EscEncoderSession::mayStart(const Job &job) const
{
    if (!m_line.isOpen())
        return refuse(RefusalKind::link, RefusalId::lineClosed);
    return codewheel::mayStart(m_line.latest(), job, place().shown(), m_line.linkName());
}

void EscEncoderSession::post(JobCommand command)
{
    std::visit([this](auto &one) { m_line.post(std::move(one)); }, command);
}

void EscEncoderSession::report(Message message, Instant at)
{
    message.at = at;
    message.place = place();
    m_line.tell(std::move(message));
}

Instant EscEncoderSession::now() const
{
    return m_line.latest().at;
}

Instant EscEncoderSession::instantOf(const QDateTime &time) const
{
    return m_line.instantOf(time);
}

} // namespace codewheel
