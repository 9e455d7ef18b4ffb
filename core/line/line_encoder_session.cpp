// SPDX-License-Identifier: GPL-3.0-or-later
#include "line/line_encoder_session.h"

#include "line/line_permission.h"
#include "line/line_session.h"

namespace codewheel {

LineEncoderSession::LineEncoderSession(LineSession &line, std::size_t device, LineAddress address,
                                       const DeviceDescription &description)
    : DrivenEncoderSession(DeviceNumber::onLine(address), description)
    , m_line(line)
    , m_device(device)
{
    connect(&line, &LineSession::stateChanged, this, &EncoderSession::permissionChanged);
}

QDateTime LineEncoderSession::dateTime(Instant at) const
{
    return m_line.dateTime(at);
}

Result<void> LineEncoderSession::mayStart(const Job &job) const
{
    if (!m_line.isOpen())
        return refuse(RefusalKind::link, RefusalId::lineClosed);
    return codewheel::mayStart(m_line.latest(), job, number().line, m_line.linkName());
}

void LineEncoderSession::postStart(JobId id, const Job &job, Pace pace)
{
    m_line.post(line_command::StartJob{m_device, id, job, pace});
}

void LineEncoderSession::postProceed()
{
    m_line.post(line_command::Proceed{m_device});
}

void LineEncoderSession::postCancel(OnCancel how)
{
    m_line.post(line_command::Cancel{m_device, how});
}

void LineEncoderSession::postKnown(std::vector<Known> known)
{
    m_line.post(line_command::SetKnown{m_device, std::move(known)});
}

void LineEncoderSession::report(Message message, Instant at)
{
    message.at = at;
    message.place = number();
    Q_EMIT m_line.messaged(message);
}

Instant LineEncoderSession::now() const
{
    return m_line.latest().at;
}

} // namespace codewheel
