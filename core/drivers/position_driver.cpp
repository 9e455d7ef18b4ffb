// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivers/position_driver.h"

#include "catalog/position_format.h"

namespace codewheel {
namespace {

// Why an encoder that only tells its position does not take the job.
struct WhyNot
{
    const DeviceDescription &device;

    RefusalId operator()(const ReadParameters &) const { return RefusalId::readingNotSupported; }
    RefusalId operator()(const WriteParameters &) const { return RefusalId::writingNotSupported; }
    RefusalId operator()(const EndParameterization &) const { return RefusalId::writingNotSupported; }
    RefusalId operator()(const SetPreset &) const { return RefusalId::presetNotSupported; }
    RefusalId operator()(const ResetToDefault &) const { return RefusalId::resetNotSupported; }
    RefusalId operator()(const SwitchMode &job) const
    {
        return job.mode == Mode::cam ? RefusalId::camsNotSupported : RefusalId::velocityNotSupported;
    }
    RefusalId operator()(const ReadCams &) const { return RefusalId::camsNotSupported; }
    RefusalId operator()(const WriteCams &) const { return RefusalId::camsNotSupported; }
    RefusalId operator()(const SendWords &) const
    {
        return device.outWords == 0 ? RefusalId::sendingNotSupported : RefusalId::jobNotSupported;
    }
    template <typename Other>
    RefusalId operator()(const Other &) const
    {
        return RefusalId::jobNotSupported;
    }
};

} // namespace

PositionDriver::PositionDriver(const DeviceDescription &device)
    : m_device(device)
    , m_format(positionFormat(device))
{
    m_reading.mode = Mode::position;
    m_reading.coding = m_format.coding;
}

Result<void> PositionDriver::begin(JobId, const Job &job, Pace, Word, Word, Instant)
{
    return refuse(RefusalKind::notSupported, std::visit(WhyNot{m_device}, job), {m_device.fullName()});
}

Word PositionDriver::cycle(Word in, Word out, Instant now)
{
    m_reading.at = now;
    m_reading.in = in;
    m_reading.position = position_word::position(in, m_format);
    m_reading.state = m_reading.position ? EncoderState::operation : EncoderState::unknown;
    return out;
}

} // namespace codewheel
