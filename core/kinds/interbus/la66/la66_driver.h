// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/la66/la66_run.h"
#include "kinds/interbus/words/word_driver.h"

namespace codewheel {

// Drives a TR LA-66: turns a job into services, carries them out step by step, and leaves OUT at 0 in normal
// mode. Service bit and data never change in the same cycle, whatever happens to the job.
class La66Driver final : public WordDriver<La66Encoder, La66Run>
{
public:
    // The description must outlive the driver.
    explicit La66Driver(const DeviceDescription &device, La66Timing timing = {})
        : WordDriver(device, timing)
    {}

    void setOthersWrite(bool on) override { m_encoder.knowledge.setOthersWrite(on); }
    void loseSight(Word out) override { m_encoder.loseSightByHand(out); }
};

} // namespace codewheel
