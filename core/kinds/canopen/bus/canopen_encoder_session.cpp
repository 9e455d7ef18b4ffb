// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/bus/canopen_encoder_session.h"

#include "jobs/values_to_write.h"
#include "kinds/canopen/bus/canopen_bus_refusals.h"
#include "kinds/canopen/bus/canopen_session.h"
#include "kinds/canopen/protocol/canopen_address.h"

namespace codewheel {

CanopenEncoderSession::CanopenEncoderSession(CanopenSession &bus, std::size_t device, int node,
                                             const DeviceDescription &description)
    : DrivenEncoderSession(device, bus.placeOf(CanopenAddress{node}.place()), description)
    , m_bus(bus)
{
    connect(&bus, &CanopenSession::stateChanged, this, &EncoderSession::permissionChanged);
}

QDateTime CanopenEncoderSession::dateTime(Instant at) const
{
    return m_bus.dateTime(at);
}

Result<std::vector<Step>> CanopenEncoderSession::planned(const std::vector<Job> &jobs) const
{
    return stepsForJobs(*this, jobs, Word{});
}

Result<void> CanopenEncoderSession::mayStart(const Job & /*job*/) const
{
    if (!m_bus.isOpen())
        return refuse(RefusalKind::link, CanopenBusRefusalId::closed);
    return codewheel::mayStart(m_bus.latest(), place().shown());
}

void CanopenEncoderSession::post(JobCommand command)
{
    std::visit([this](auto &one) { m_bus.post(std::move(one)); }, command);
}

void CanopenEncoderSession::report(Message message, Instant at)
{
    message.at = at;
    message.place = place();
    m_bus.tell(std::move(message));
}

Instant CanopenEncoderSession::now() const
{
    return m_bus.latest().at;
}

Instant CanopenEncoderSession::instantOf(const QDateTime &time) const
{
    return m_bus.instantOf(time);
}

} // namespace codewheel
