// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/encoder_session.h"
#include "vocabulary/event.h"

#include <QPointer>

namespace codewheel {

// Presents a handshake of several consecutive jobs as one: the finished jobs, followed by the running one.
// The wizard runs such handshakes, and the parameter panel says how they ended.
class DoneJobs
{
public:
    // progress: the last one of the job, with the steps of the jobs before it.
    void add(const Progress &progress, const Outcome &outcome);

    Progress followedBy(Progress progress) const;
    Outcome followedBy(Outcome outcome) const;
    bool areNone() const { return m_outcomes.empty(); }
    bool haveSetPosition() const { return m_haveSetPosition; }

private:
    std::vector<Step> m_steps;
    std::vector<Outcome> m_outcomes;
    bool m_haveSetPosition = false;
};

// A job that goes on with the handshake of others.
struct FollowingJob
{
    QPointer<EncoderSession> encoder;
    JobId job = 0;
    DoneJobs before;
};

} // namespace codewheel
