// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/la66/la66_knowledge.h"
#include "kinds/interbus/la66/la66_plan.h"
#include "kinds/interbus/words/la66_word.h"
#include "vocabulary/position_speed.h"
#include "vocabulary/reading.h"

namespace codewheel {

// One LA-66 as currently known: what it shows, what it has. Shared by the driver and by the job in progress.
struct La66Encoder
{
    // The description must outlive this.
    La66Encoder(const DeviceDescription &device, La66Timing how)
        : timing(how)
        , knowledge(device)
        , plan(device, timing)
    {
        speed.setScale(PositionSpeed::Scale{.stepsPerTurn = finestStepsIn100Millimetres});
    }

    void setKnown(const std::vector<Known> &known) { knowledge.values().set(known); }
    Result<void> check(const Job &job) const { return plan.check(job); }
    void observe(Word in, Word out, Instant now);
    static bool isAnswer(Word in) { return la66::isServiceMode(in); }
    void forget(Parameter parameter);
    // No job is running: what `out`, whose answer nobody sees, may have written is reported as in doubt.
    void loseSightByHand(Word out);
    void reportChanges();

    static constexpr double finestStepsIn100Millimetres = 20'000; // of 0.005 mm (assumed)

    La66Timing timing;
    La66Knowledge knowledge;
    La66Plan plan;
    PositionSpeed speed;
    Reading reading;
    std::vector<Event> events;
};

} // namespace codewheel
