// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/call/complaint.h"
#include "transfer/job_round.h"

namespace codewheel {

struct Call;
enum class AsksAnyway;

// A job that may be carried out as far as the EEPROM of its encoder is concerned. Made by eepromConsent(),
// and all that runToEnd() accepts: so no command can forget to ask.
class AllowedJob
{
public:
    // Reading values writes nothing.
    AllowedJob(EncoderSession &encoder, ReadParameters read)
        : m_encoder(encoder)
        , m_job(std::move(read))
    {}

    EncoderSession &encoder() const { return m_encoder; }
    const Job &job() const { return m_job; }

private:
    friend Checked<AllowedJob> eepromConsent(const Call &call, EncoderSession &encoder, const Job &job,
                                             AsksAnyway asks);
    AllowedJob(EncoderSession &encoder, Job job)
        : m_encoder(encoder)
        , m_job(std::move(job))
    {}

    EncoderSession &m_encoder;
    Job m_job;
};

// The same for the jobs of several encoders.
class AllowedRound
{
public:
    const std::vector<EncoderJobs> &encoders() const { return m_encoders; }

private:
    friend Checked<AllowedRound> eepromConsent(const Call &call, std::vector<EncoderJobs> encoders,
                                               AsksAnyway asks);
    explicit AllowedRound(std::vector<EncoderJobs> encoders)
        : m_encoders(std::move(encoders))
    {}

    std::vector<EncoderJobs> m_encoders;
};

} // namespace codewheel
