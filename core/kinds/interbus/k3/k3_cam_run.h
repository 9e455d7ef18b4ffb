// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "jobs/job_steps.h"
#include "kinds/interbus/k3/k3_encoder.h"

#include <map>

namespace codewheel {

// What a job has read of the cam programs, what the encoder has taken, and what follows from that (FRABA
// manual 5.4.4). Part of K3Run.
class K3CamRun
{
public:
    // The encoder must outlive this.
    explicit K3CamRun(const K3Encoder &encoder);

    // A read-out was answered. A refusal: what was written is not there.
    std::optional<Refusal> readOutDone(const K3Step &step, Word in);
    // Whether the current step continues reading the program of `step`.
    static bool readsOn(const JobSteps<K3Step> &steps, const K3Step &step);
    // All of a program was read: next comes what is to be written to it, and only what differs.
    void planWrite(JobSteps<K3Step> &steps, const WriteCams &job) const;
    // Everything written to the program was read back.
    void wasVerified(const WriteCams &job, unsigned program);

    void wordTaken(Word out);
    void ran() { m_isPending = false; }
    // Having lost power, the encoder has lost what was acknowledged since it entered the program.
    void losePending();

    bool hasPending() const { return m_isPending; } // something was acknowledged since the last run
    bool hasTaken() const { return !m_taken.empty(); }
    bool canRestore() const; // what the programs were before is known
    // What was written and read back so far no longer holds.
    K3Steps stepsToRestore();
    // What was written and read back may be lost until its program is left. True: some of it was, and is not
    // reported as written. If IN shows cams only, 00000000h is no sign of that.
    bool dropLost();

    std::vector<CamProgram> programsBefore() const; // of those that were changed
    const std::vector<CamProgram> &read() const { return m_read; }
    const std::vector<CamProgram> &written() const { return m_written; }

private:
    void tell(unsigned program, CamField field, std::int64_t data);

    const K3Encoder &m_encoder;
    std::map<unsigned, CamProgram> m_before; // as they were before the job, where known
    std::map<unsigned, CamFieldSet> m_taken; // acknowledged, by program
    bool m_isPending = false;
    std::vector<CamProgram> m_read;
    std::vector<CamProgram> m_written;
    CamProgram m_reading; // the program being read, as far as it has been reported
    CamFieldSet m_told;
};

} // namespace codewheel
