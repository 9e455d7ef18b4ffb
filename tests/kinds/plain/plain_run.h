// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "jobs/job_run.h"
#include "tests/kinds/plain/plain_protocol.h"

namespace codewheel::test {

// An encoder of the tests' own kind as its driver knows it.
struct PlainKnowledge
{
    const DeviceDescription &device;
    KnownValues values{};
    Reading reading{};
    std::vector<Event> events{};

    void flush();
};

// A job of such an encoder: one line after the other.
class PlainRun final : public JobRun<PlainStep>
{
public:
    PlainRun(JobId id, const Job &job, Pace pace, PlainKnowledge &encoder);

    // The next line; empty while it waits for the user, and when it is done.
    std::optional<QByteArray> next();
    void answered(const QByteArray &answer);
    void stop(const Refusal &why);

private:
    bool hasTaken() const override;
    bool isPositionStep(const PlainStep &step) const override { return step.task == PlainStep::Task::to; }
    void leaveOffAt(Instant now) override;
    void complete(Outcome &outcome) override;

    void settle();
    void leaveOutWhatIsThere();
    void done(const QByteArray &answer);
    void read(const QByteArray &answer);
    void check(const QByteArray &answer);
    void goesInForce();
    void fail(Refusal why);

    PlainKnowledge &m_encoder;
    bool mayBeLost(const ParameterValue &value) const;
    bool isUnderWay(PlainStep::Task task) const;

    ParameterValues m_given;   // and not in force yet
    ParameterValues m_toStore; // in force, found by reading
    bool m_isCompared = false;
};

} // namespace codewheel::test
