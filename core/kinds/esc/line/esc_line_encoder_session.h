// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/asked_bus.h"
#include "jobs/values_to_write.h"
#include "kinds/esc/protocol/esc_explain.h"
#include "kinds/esc/protocol/esc_forms.h"

namespace codewheel {

class EscLineSession;

// An encoder on a serial line, as views see it.
class EscEncoderSession final : public AskedEncoder
{
    Q_OBJECT

public:
    EscEncoderSession(EscLineSession &line, std::size_t device, NodeId node,
                      const DeviceDescription &description);

    bool agreesOnPositions() const override { return true; }
    KindData valueOptions() const override
    {
        return KindData(
            EscValueOptions{.swapsWarningBytes = m_swapsWarningBytes, .fractionBits = fractionBits()});
    }
    Result<std::vector<Step>> planned(const std::vector<Job> &jobs) const override;
    int fractionBits() const; // of its scaling factor, as set for its line
    bool swapsWarningBytes() const { return m_swapsWarningBytes; }

private:
    friend class EscLineSession;
    Result<void> checkAddress(const Job &job) const;

    EscLineSession &m_line;
    bool m_swapsWarningBytes = false;
};

} // namespace codewheel
