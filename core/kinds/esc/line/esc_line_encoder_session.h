// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "jobs/driven_encoder_session.h"
#include "jobs/values_to_write.h"
#include "kinds/esc/protocol/esc_explain.h"
#include "kinds/esc/protocol/esc_forms.h"
#include "kinds/esc/protocol/esc_request.h"

namespace codewheel {

class EscLineSession;

// An encoder on a serial line, as views see it: turns jobs into commands for the runner, and what
// EscLineSession pumps out of the line thread into signals.
class EscEncoderSession final : public DrivenEncoderSession
{
    Q_OBJECT

public:
    EscEncoderSession(EscLineSession &line, std::size_t device, EscLineAddress address,
                      const DeviceDescription &description);

    bool agreesOnPositions() const override { return true; }
    KindData valueOptions() const override
    {
        return KindData(
            EscValueOptions{.swapsWarningBytes = m_swapsWarningBytes, .fractionBits = fractionBits()});
    }
    QDateTime dateTime(Instant at) const override;
    Result<std::vector<Step>> planned(const std::vector<Job> &jobs) const override;
    int fractionBits() const; // of its scaling factor, as set for its line
    bool swapsWarningBytes() const { return m_swapsWarningBytes; }

private:
    friend class EscLineSession;
    Result<void> checkAddress(const Job &job) const;
    Result<void> mayStart(const Job &job) const override;
    void post(JobCommand command) override;
    void report(Message message, Instant at) override;
    Instant now() const override;
    Instant instantOf(const QDateTime &time) const override;

    EscLineSession &m_line;
    bool m_swapsWarningBytes = false;
};

} // namespace codewheel
