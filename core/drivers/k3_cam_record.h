// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cams/cam_fields.h"

#include <map>
#include <vector>

namespace codewheel {

// What a job has read of the cam programs and what the encoder has taken of it. Part of K3Driver's run.
struct K3CamRecord
{
    std::map<unsigned, CamProgram> before; // as they were before the job changed them, where that is known
    std::map<unsigned, CamFieldSet> taken; // acknowledged, by program
    bool isPending = false;                // something was acknowledged since the last run
    std::vector<CamProgram> read;
    std::vector<CamProgram> written;

    // A value of a program that is being read. True: now all of it was.
    bool tell(unsigned program, CamField field, std::int64_t data);
    void take(unsigned program, CamField field);
    bool canRestore() const;

private:
    CamProgram m_reading;
    CamFieldSet m_told;
};

} // namespace codewheel
