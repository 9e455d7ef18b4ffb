// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/position/position_driver.h"

#include "jobs/job_check.h"
#include "jobs/position_scale.h"
#include "kinds/interbus/meaning/position_format.h"

namespace codewheel {
PositionDriver::PositionDriver(const DeviceDescription &device)
    : m_device(device)
    , m_format(positionFormat(device))
{
    m_reading.mode = Mode::position;
    m_reading.coding = m_format.coding;
    m_speed.setScale(speedScaleOf(device, [](Parameter) { return std::nullopt; }));
}

Result<void> PositionDriver::begin(JobId, const Job &job, Pace, Word, Word, Instant)
{
    if (auto checked = checkJob(m_device, job); !checked)
        return checked;
    return refuse(RefusalKind::notSupported, RefusalId::jobNotSupported, {m_device.fullName()});
}

Word PositionDriver::cycle(Word in, Word out, Instant now)
{
    m_reading.at = now;
    m_reading.in = in;
    m_reading.position = position_word::position(in, m_format);
    m_reading.state = m_reading.position ? EncoderState::operation : EncoderState::unknown;
    m_reading.stepsPerSecond = m_speed.after(m_reading.position, now);
    m_reading.mayMissTurns = m_speed.mayMissTurns();
    return out;
}

} // namespace codewheel
