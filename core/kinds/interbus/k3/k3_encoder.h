// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/k3/k3_knowledge.h"
#include "kinds/interbus/k3/k3_plan.h"
#include "kinds/interbus/k3/k3_preset_proof.h"
#include "kinds/interbus/k3/k3_reading.h"
#include "vocabulary/position_speed.h"

namespace codewheel {

// One K3 encoder as currently known: what it shows, what it has, which jobs it accepts. Shared by the driver
// and by the job in progress.
struct K3Encoder
{
    // The description must outlive this.
    K3Encoder(const DeviceDescription &description, K3Timing how);

    void setKnown(const std::vector<Known> &known);
    void forget();
    // One bus cycle.
    void observe(Word in, Word out, Instant now);
    // What it does contradicts a mode that was only told.
    void doubtMode();
    // A job has ended, and nobody sees any more what IN shows, nor what becomes of `out`, which is in OUT or
    // on its way there. Returns how many writes that may cost which are not counted.
    int loseSight(Word out);
    // No job is running: what is in doubt is reported.
    void loseSightByHand(Word out);
    EncoderState stateOf(Word in) const { return codewheel::stateOf(in, device.dialect.as<k3::Dialect>()); }
    static bool isAnswer(Word in) { return k3::isReadOutAnswer(in); }
    bool isError(Word in) const { return isErrorAnswer(in, device.dialect.as<k3::Dialect>()); }

    // Whether the job suits this encoder, in the mode it is in as far as that is known.
    Result<void> check(const Job &job) const;
    // Whether it may begin with `in` in IN.
    Result<void> checkState(const Job &job, Word in) const;

    const DeviceDescription &device;
    void countStanding(); // see CyclicDriver::leaveStanding()

    K3Timing timing;
    K3Knowledge knowledge;
    K3Plan plan;
    Reading reading;
    K3PresetProof preset;
    std::vector<Event> events;

private:
    Result<void> checkMode(const Job &job) const;
    void read(Word in, Instant now);
    void updateScale();
    void reportChanges();

    PositionSpeed m_speed;
};

Refusal noValidPosition();

} // namespace codewheel
