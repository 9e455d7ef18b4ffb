// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "kinds/esc/driver/esc_settings.h"
#include "kinds/esc/protocol/esc_request.h"
#include "vocabulary/event.h"

#include <map>
#include <vector>

namespace codewheel {

// A step of a job as carried out by the driver of serial encoders. Step::line is its request.
struct EscStep : Step
{
    enum class Task : std::uint8_t {
        read,           // until two reads agree; the value is part of the outcome
        refresh,        // the same, but it only updates what is known, and may fail
        write,          // sent once
        readBack,       // what was written must be found
        positionBefore, // before the first write
        positionAfter,  // after the last
        search,         // for the encoder whose address or baud rate was changed
    };

    Task task = Task::read;
    esc::Request request{};
    std::int64_t value = 0; // write, readBack: of the parameter; positionAfter: the preset
};
using EscSteps = std::vector<EscStep>;

// What a job means in requests, step by step (Kübler manual, ESC commands). No I/O; what is read on the way
// refines it (esc_job.cpp).
class EscPlan
{
public:
    // What answers at the other addresses of the line, with a name for the user.
    using Taken = std::map<EscLineAddress, QString>;

    EscPlan(const DeviceDescription &device, EscLineAddress address, const EscSettings &settings,
            ParameterValues known, const Taken &taken = {})
        : m_device(device)
        , m_address(address)
        , m_settings(settings)
        , m_known(std::move(known))
        , m_taken(taken)
    {}

    // Whether the job suits this encoder: parameters it has, values within its own limits, an address that is
    // free. Bad input is refused here.
    Result<void> check(const Job &job) const;
    EscSteps stepsFor(const Job &job) const;

    // Between the positions before and after, in the order they are carried out: address and baud rate last,
    // since everything else is sent to where the encoder still is; the scaling factor after the values it is
    // computed from.
    EscSteps writes(const ParameterValues &values) const;
    EscStep readBack(const EscStep &write) const;

private:
    Result<void> checkWrite(const WriteParameters &job) const;
    Result<void> checkPreset(const SetPreset &job) const;
    Result<void> checkAddress(EscLineAddress wanted) const;

    EscSteps preset(std::int64_t position) const;
    ParameterValues completed(const ParameterValues &values) const;
    EscStep step(EscStep::Task task, esc::Command command, std::uint32_t data = 0) const;
    EscStep reading(EscStep::Task task, Parameter parameter) const;
    EscStep writing(const ParameterValue &value) const;
    void appendReads(EscSteps &steps, const std::vector<Parameter> &parameters) const;
    void appendScaling(EscSteps &steps, const ParameterValues &values) const;

    const DeviceDescription &m_device;
    EscLineAddress m_address;
    EscSettings m_settings;
    ParameterValues m_known;
    Taken m_taken;
};

// Whether the parameter belongs to the scaling, whose commands take effect together (manual, note on GR, GT
// and GF).
bool isEscScaling(Parameter parameter);
// Whether a job that wrote these has to send the scaling factor.
bool isBoundToEscFactor(Parameter parameter);
// Whether a value must be sent along with those written even if the encoder already has it: a scaling factor,
// since otherwise one would be computed and sent; revolutions and measuring range with the steps, which
// change them (manual, GR).
bool goesAlongOnEsc(Parameter parameter, const ParameterValues &written);

} // namespace codewheel
