// SPDX-License-Identifier: GPL-3.0-or-later
// What went wrong, named for the user.
#include "drivers/k3_driver.h"

#include <algorithm>

namespace codewheel {

Refusal K3Driver::refusalFor(Word in) const
{
    if (auto aboutCams = camRefusalFor(in))
        return *std::move(aboutCams);
    if (current().kind == StepKind::readOut || k3::isReadOutRequest(current().out)) {
        if (stateOf(in, m_device.dialect) == EncoderState::readOut)
            return {
                RefusalKind::device, RefusalId::readOutUnknown, {std::int64_t{current().out & 0xFFFF}, in}};
    }
    const unsigned number = k3::number(in);
    const DeviceError *error = m_device.findError(number);
    const RefusalId id = error != nullptr ? error->meaning : RefusalId::otherDeviceError;
    std::vector<RefusalArgument> arguments;
    if (id == RefusalId::wrongParameterData || id == RefusalId::unknownParameterNumber)
        arguments = suspects();
    else if (id == RefusalId::manufacturerError)
        arguments = {std::int64_t{in & 0xFF}};
    else if (id == RefusalId::otherDeviceError)
        arguments = {std::int64_t{number}};
    arguments.emplace_back(in);
    return {RefusalKind::device, id, std::move(arguments)};
}

// An error that comes before the word was confirmed may be about the one before; an error at run is about the
// set.
std::vector<RefusalArgument> K3Driver::suspects() const
{
    const Run &run = *m_run;
    std::vector<RefusalArgument> suspects;
    const K3Step &step = current();
    if (k3::isParameterWord(step.out)) {
        if (!m_handshake.hasConfirmed() && !run.confirmed.empty())
            suspects.emplace_back(run.confirmed.back().parameter);
        if (step.parameter)
            suspects.emplace_back(*step.parameter);
        else
            suspects.emplace_back(std::int64_t{k3::number(step.out)});
        return suspects;
    }
    for (const ParameterValues *taken : {&run.confirmed, &run.written})
        for (const ParameterValue &value : *taken)
            suspects.emplace_back(value.parameter);
    return suspects;
}

Refusal K3Driver::noAnswer(Word in) const
{
    return {RefusalKind::device,
            RefusalId::noAnswer,
            {std::chrono::duration<double>(m_timing.timeOut).count(), current().out, in}};
}

Refusal K3Driver::restarted(Word in)
{
    return {RefusalKind::device, RefusalId::restarted, {in}};
}

Refusal K3Driver::noValidPosition()
{
    return {RefusalKind::device, RefusalId::noValidPosition, {k3::error}};
}

} // namespace codewheel
