// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "kinds/interbus/la66/la66_step.h"

namespace codewheel {

// What a job means in words, step by step: the services of LA-66 manual 3. No I/O; what is read on the way
// refines it (la66_run.cpp).
class La66Plan
{
public:
    La66Plan(const DeviceDescription &device, La66Timing timing)
        : m_device(device)
        , m_timing(timing)
    {}

    // Whether the job suits this encoder: parameters it has, values in range. Bad input is refused here.
    Result<void> check(const Job &job) const;

    // From normal mode with `out` in OUT, and back to normal mode with 00000000h; words of the user end where
    // the user ends them.
    La66Steps stepsFor(const Job &job, Word out) const;

    // From `out` to 00000000h: the service bit first, the rest once the encoder is in normal mode.
    static La66Steps wayBack(Word out);
    // The service bit of `out` back to 0, the rest kept until the encoder has followed.
    static La66Step endOfService(Word out);
    La66Steps writes(const ParameterValues &values) const;

private:
    La66Steps reads(const std::vector<Parameter> &parameters) const;
    La66Steps words(const SendWords &job, Word out) const;

    const DeviceDescription &m_device;
    La66Timing m_timing;
};

} // namespace codewheel
