// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "drivers/job_steps.h"
#include "drivers/k3_encoder.h"

#include <map>

namespace codewheel {

// What a job has read of the cam programs, what the encoder has taken of it, and what follows from that
// (FRABA manual 5.4.4). Part of K3Run.
class K3CamRun
{
public:
    // The encoder must outlive this.
    explicit K3CamRun(const K3Encoder &encoder);

    // A read-out was answered. A refusal: what was written is not there.
    std::optional<Refusal> readOutDone(const K3Step &step, Word in);
    // Whether the current step goes on reading the program of this one.
    static bool readsOn(const JobSteps<K3Step> &steps, const K3Step &step);
    // All of a program was read: what is to be written to it follows, and only what differs.
    void planWrite(JobSteps<K3Step> &steps, const WriteCams &job) const;
    // All that was written to the program was read back.
    void wasVerified(const WriteCams &job, unsigned program);

    void wordTaken(Word out);
    void ran() { m_isPending = false; }
    // Without its power the encoder has lost what was acknowledged since it entered the program.
    void losePending();

    bool hasPending() const { return m_isPending; } // something was acknowledged since the last run
    bool hasTaken() const { return !m_taken.empty(); }
    bool canRestore() const; // what the programs were before is known
    // What was written and read back until now does not hold any more.
    K3Steps stepsToRestore();
    // What was written and read back may be lost until its program is left. True: some of it was, and is not
    // told as written. With the cams only, 00000000h in IN is no sign of that.
    bool dropLost();

    std::vector<CamProgram> programsBefore() const; // of those that were changed
    const std::vector<CamProgram> &read() const { return m_read; }
    const std::vector<CamProgram> &written() const { return m_written; }

private:
    void tell(unsigned program, CamField field, std::int64_t data);

    const K3Encoder &m_encoder;
    std::map<unsigned, CamProgram> m_before; // as they were before the job, where that is known
    std::map<unsigned, CamFieldSet> m_taken; // acknowledged, by program
    bool m_isPending = false;
    std::vector<CamProgram> m_read;
    std::vector<CamProgram> m_written;
    CamProgram m_reading; // the program that is being read, and what of it was told
    CamFieldSet m_told;
};

} // namespace codewheel
