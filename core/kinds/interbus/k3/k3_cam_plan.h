// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/k3/k3_plan.h"

namespace codewheel {

// What the cam jobs mean in words (FRABA manual 5.4.4). The part of K3Plan that is about cams.
//
// A program is entered by 2080000p, which is not acknowledged. That the encoder understands cam words is
// known once it answers a cam read-out, which sets nothing in any mode; no other cam word goes out before.
// The program the encoder is in comes first, so that none is left without need.
class K3CamPlan
{
public:
    K3CamPlan(const DeviceDescription &device, const K3Knowledge &knowledge)
        : m_device(device)
        , m_knowledge(knowledge)
    {}

    Result<void> check(const ReadCams &job) const;
    Result<void> check(const WriteCams &job) const;
    Result<void> check(const SwitchMode &job) const;

    K3Steps stepsFor(const ReadCams &job) const;
    K3Steps stepsFor(const WriteCams &job) const;
    // 2080000p, followed by 00000000.
    K3Steps stepsFor(const SwitchMode &job) const;

    // What follows once the program was read: the fields, run, and reading them back; nothing without fields.
    // `saves`: then leave the program, which saves it, and enter it again.
    static K3Steps write(const CamProgram &program, CamFieldSet fields, bool saves);
    // Restores the values of these fields and reads them back, in the program the encoder is in or, with
    // `enters`, in another.
    static K3Steps restore(const CamProgram &program, CamFieldSet fields, bool enters);

private:
    Result<void> checkPrograms(const std::vector<unsigned> &programs,
                               const std::optional<SwitchMode> &afterwards) const;
    std::int64_t largestPosition() const;
    std::vector<unsigned> currentFirst(std::vector<unsigned> programs) const;
    CamFieldSet fieldsToWrite(const CamProgram &program, bool onlyWhatDiffers) const;

    const DeviceDescription &m_device;
    const K3Knowledge &m_knowledge;
};

} // namespace codewheel
