// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/simulator/training_fault.h"
#include "kinds/interbus/words/device_number.h"
#include "vocabulary/refusal.h"

#include <QString>

#include <chrono>
#include <vector>

namespace codewheel {

struct FaultStep
{
    std::chrono::milliseconds at{}; // since the plan was started, by the clock of the ring
    TrainingFault fault = TrainingFault::wireBreak;
    NodeId place;
    int value = 1; // 0: off, 1: on; CRC errors: per 1000 data cycles

    friend bool operator==(const FaultStep &, const FaultStep &) = default;
};

// A lesson or a test that runs the same way every time.
struct FaultPlan
{
    QString title;
    std::vector<FaultStep> steps; // by time; at least one

    friend bool operator==(const FaultPlan &, const FaultPlan &) = default;
};

// A place of the ring, and the faults that fit it.
struct TrainingPlace
{
    struct Standing
    {
        TrainingFault fault = TrainingFault::wireBreak;
        int value = 0; // as in FaultStep

        friend bool operator==(const Standing &, const Standing &) = default;
    };

    NodeId number;
    std::vector<Standing> faults; // in the order of TrainingFault
};

// The plan in `json` for a ring with these places, or the first thing wrong with it: faultPlanBroken. Its
// form is documented in docs/fault-plans.md. `name` is the file's, for the sentence.
Result<FaultPlan> faultPlanFromJson(const QByteArray &json, const QString &name,
                                    const std::vector<TrainingPlace> &ring);

// The fault plan in the file at `path`: fileNotReadable, fileTooLarge, or what faultPlanFromJson() refuses.
Result<FaultPlan> loadFaultPlan(const QString &path, const std::vector<TrainingPlace> &ring);

// "1.0: Wire break before it, 3.0: Peripheral fault", in the user's language: the faults that stand in a ring
// with these places; empty: none. That a device without supply, or one that was replaced, is switched off too
// goes without saying.
QString standingFaultsText(const std::vector<TrainingPlace> &ring);

} // namespace codewheel
