// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "jobs/known_values.h"
#include "kinds/esc/driver/esc_plan.h"
#include "kinds/esc/driver/esc_position_guard.h"
#include "kinds/esc/driver/esc_settings.h"
#include "kinds/esc/protocol/esc_exchange.h"
#include "vocabulary/message.h"
#include "vocabulary/position_speed.h"
#include "vocabulary/reading.h"

#include <map>

namespace codewheel {

// One encoder on a serial line as currently known: where it is, what it shows, what it has. Shared by the
// driver, which polls it, and by the job in progress.
class EscEncoder
{
public:
    // The description must outlive this.
    EscEncoder(const DeviceDescription &description, EscLineAddress place, EscSettings how);

    const DeviceDescription &device;
    EscSettings settings;
    EscLineAddress address;
    std::optional<int> baudRate;       // of the line, as told; empty: not known
    std::optional<int> wantedBaudRate; // while the encoder needs a different one
    EscPlan::Taken taken;              // by other encoders of the line
    Reading reading;
    KnownValues values;
    EscPositionGuard guard;
    QString version;
    std::vector<Event> events;
    std::vector<Message> messages;

    EscPlan plan() const { return {device, address, settings, values.values(), taken}; }

    // The position may be anything now: earlier ones do not predict later ones.
    void forgetPosition();
    // An answer to P. False: it is suspect and must be asked for again.
    bool takePosition(std::uint32_t position, Instant now);
    // Warnings or alarms that have not changed.
    bool saysTheSame(esc::Command command, const esc::Answer &answer) const;
    // A value that two reads agreed on.
    void take(esc::Command command, const esc::Answer &answer, Instant now);
    void setSwapsWarningBytes(bool on); // from now on
    // A write was carried out, or may have been: what depends on it is no longer known.
    void mayHaveChanged(esc::Command command);

    void tell(Instant now, Severity severity, MessageCode id, std::vector<RefusalArgument> arguments = {});
    void flushKnowledge();

private:
    std::uint16_t bitsOf(esc::Command command, const esc::Answer &answer) const;
    void updateScale();
    void tellSuspect(std::int64_t position, Instant now);

    PositionSpeed m_speed;
    bool m_versionChanged = false;
    std::optional<Instant> m_suspectTold;
};

// It has digits or text: an answer that says more than 03, 05 or a bare line end.
bool hasValue(const std::optional<esc::Answer> &answer);

} // namespace codewheel
