// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/cams/cam_jobs.h"

namespace codewheel {

Result<void> CamJobs::start(EncoderSession &encoder, Purpose purpose, const Job &job)
{
    const auto started = encoder.start(job);
    if (!started)
        return tl::unexpected(started.error());
    const Place number = encoder.place();
    const auto connection = connect(&encoder, &EncoderSession::finished, this,
                                    [this, number](const Outcome &outcome) { finish(number, outcome); });
    m_running.insert_or_assign(number, Running{*started, purpose, connection});
    return {};
}

void CamJobs::finish(Place number, const Outcome &outcome)
{
    const auto found = m_running.find(number);
    if (found == m_running.end() || found->second.job != outcome.job)
        return;
    const Running running = found->second;
    disconnect(running.connection);
    m_running.erase(found);
    Q_EMIT ended(number, running.purpose, outcome);
}

std::optional<SwitchMode> modeNow(const EncoderSession &encoder)
{
    const Reading &reading = encoder.latest();
    if (!reading.mode || (*reading.mode == Mode::cam && !reading.camProgram))
        return std::nullopt;
    return SwitchMode{.mode = *reading.mode, .camProgram = reading.camProgram.value_or(0)};
}

} // namespace codewheel
