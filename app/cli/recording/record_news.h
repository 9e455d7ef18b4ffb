// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/call/subcommand.h"
#include "recording/bus_recorder.h"
#include "vocabulary/instant.h"

#include <chrono>
#include <set>

namespace codewheel {

// Tells what happens while a recording goes on, the moment it happens: on standard error what goes wrong and
// when that is over, and for somebody at a terminal how far it is.
class RecordNews
{
public:
    RecordNews(const Call &call, const BusRecorder &recorder)
        : m_call(call)
        , m_recorder(recorder)
    {}
    ~RecordNews() { m_call.terminal.showProgress({}); }
    Q_DISABLE_COPY_MOVE(RecordNews)

    void look(Instant passed); // since the recording, or waiting, began

private:
    using Clock = std::chrono::steady_clock;

    void tell(const QString &text) const;
    void lookAtFile(const RecordingStatus &status);
    void lookAtBuses();
    QString progress(const RecordingStatus &status, Instant passed) const;

    const Call &m_call;
    const BusRecorder &m_recorder;
    BusRecorder::State m_state = m_recorder.state();
    std::optional<RefusalCode> m_problem;
    bool m_hasLost = false;
    std::set<const BusAccess *> m_gone;
    Clock::time_point m_nextProgress{};
};

} // namespace codewheel
