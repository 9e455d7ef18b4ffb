// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "kinds/interbus/words/cyclic_driver.h"
#include "kinds/interbus/words/position_word.h"
#include "vocabulary/position_speed.h"

namespace codewheel {

// Drives nothing: reports the position of a K1, K2 or K4 and refuses every job. A K4 can be set up through
// PCP, which is not ours to guess; no source describes its OUT word, so nothing is ever sent to it.
class PositionDriver final : public CyclicDriver
{
public:
    // The description must outlive the driver.
    explicit PositionDriver(const DeviceDescription &device);

    const Reading &reading() const override { return m_reading; }
    bool busy() const override { return false; }
    void setKnown(const std::vector<Known> &) override {}
    Result<void> begin(JobId id, const Job &job, Pace pace, Word in, Word out, Instant now) override;
    void proceed() override {}
    void cancel(OnCancel, Instant) override {}
    void stop(const Refusal &, Instant) override {}
    Word cycle(Word in, Word out, Instant now) override;
    std::vector<Event> takeEvents() override { return {}; }

private:
    const DeviceDescription &m_device;
    PositionWord m_format;
    PositionSpeed m_speed;
    Reading m_reading;
};

} // namespace codewheel
