// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/k3/k3_run.h"
#include "kinds/interbus/words/word_driver.h"

namespace codewheel {

// Drives a K3 encoder of any make, as its description says: plans the steps of a job, carries them out one by
// one, refines the plan by what it reads, and ends in a known state (K3Run).
class K3Driver final : public WordDriver<K3Encoder, K3Run>
{
public:
    // The description must outlive the driver.
    explicit K3Driver(const DeviceDescription &device, K3Timing timing = {})
        : WordDriver(device, timing)
    {}

    void forget() override
    {
        WordDriver::forget();
        m_encoder.forget(); // its mode and its cams too
    }
    void expectTornWords() override
    {
        WordDriver::expectTornWords();
        m_encoder.knowledge.expectTornWords();
    }
    void setOthersWrite(bool on) override { m_encoder.knowledge.setOthersWrite(on); }
    void leaveStanding() override { m_encoder.countStanding(); }
    void loseSight(Word out) override { m_encoder.loseSightByHand(out); }
    bool mayStand(Word out) const override { return !m_encoder.knowledge.isManufacturerPreset(out); }
};

} // namespace codewheel
