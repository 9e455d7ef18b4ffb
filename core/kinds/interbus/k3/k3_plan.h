// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "kinds/interbus/k3/k3_knowledge.h"
#include "kinds/interbus/k3/k3_step.h"

namespace codewheel {

// What a job means in words, step by step. No I/O: a plan is made from the job, the description and what is
// known; what is read on the way refines it (k3_refine.h).
class K3Plan
{
public:
    K3Plan(const DeviceDescription &device, const K3Knowledge &knowledge)
        : m_device(device)
        , m_knowledge(knowledge)
    {}

    // Whether the job suits this encoder: parameters it has, values in range. Bad input is refused here.
    Result<void> check(const Job &job) const;
    K3Steps stepsFor(const Job &job) const;

    // Ends a parameterization: run, or run and the previous values, which are read back where possible.
    K3Steps endParameterization(const ParameterValues &restore, bool runFirst) const;
    static K3Step toNormal(bool mustOperate);
    // A job begins with 00000000; words sent by hand begin as they are.
    static void clearOutFirst(K3Steps &steps, const Job &job);
    static K3Step runStep(bool tolerateError);
    static K3Step switchStep(Word modeWord);
    Word parameterWord(Parameter parameter, std::int64_t value) const;
    // Its read-out, if it has one; `expected`: what must be read.
    void appendRead(K3Steps &steps, Parameter parameter, std::optional<std::int64_t> expected = {}) const;

private:
    Result<void> checkPreset(const SetPreset &job) const;

    K3Steps plan(const ReadParameters &job) const;
    K3Steps plan(const WriteParameters &job) const;
    K3Steps plan(const SetPreset &job) const;
    K3Steps plan(const SendWords &job) const;
    K3Steps plan(const EndParameterization &job) const;
    K3Steps plan(const SwitchMode &job) const;
    K3Steps plan(const ResetToDefault &job) const;
    K3Steps plan(const ReadCams &job) const;
    K3Steps plan(const WriteCams &job) const;

    bool needsStepsFlag(const ParameterValues &values) const;
    void appendWrites(K3Steps &steps, const ParameterValues &values) const;
    void appendPresetRead(K3Steps &steps) const;
    void appendPreset(K3Steps &steps) const;
    K3Steps manufacturerPreset(std::optional<std::int64_t> value) const;
    void appendPositionMode(K3Steps &steps) const;

    const DeviceDescription &m_device;
    const K3Knowledge &m_knowledge;
};

} // namespace codewheel
