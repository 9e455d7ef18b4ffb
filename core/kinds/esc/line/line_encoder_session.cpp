// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/line/line_encoder_session.h"

#include "kinds/esc/line/line_permission.h"
#include "kinds/esc/line/line_session.h"

namespace codewheel {

LineEncoderSession::LineEncoderSession(LineSession &line, std::size_t device, LineAddress address,
                                       const DeviceDescription &description)
    : DrivenEncoderSession(device, line.placeOf(address.node()), description)
    , m_line(line)
{
    connect(&line, &LineSession::stateChanged, this, &EncoderSession::permissionChanged);
}

QDateTime LineEncoderSession::dateTime(Instant at) const
{
    return m_line.dateTime(at);
}

Result<std::vector<Step>> LineEncoderSession::planned(const std::vector<Job> &jobs) const
{
    return stepsForJobs(*this, jobs, Word{});
}

int LineEncoderSession::fractionBits() const
{
    return m_line.fractionBits();
}

Result<void> LineEncoderSession::mayStart(const Job &job) const
{
    if (!m_line.isOpen())
        return refuse(RefusalKind::link, RefusalId::lineClosed);
    return codewheel::mayStart(m_line.latest(), job, place().shown(), m_line.linkName());
}

void LineEncoderSession::post(JobCommand command)
{
    std::visit([this](auto &one) { m_line.post(std::move(one)); }, command);
}

void LineEncoderSession::report(Message message, Instant at)
{
    message.at = at;
    message.place = place();
    m_line.tell(std::move(message));
}

Instant LineEncoderSession::now() const
{
    return m_line.latest().at;
}

Instant LineEncoderSession::instantOf(const QDateTime &time) const
{
    return m_line.instantOf(time);
}

} // namespace codewheel
