// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/bus/places.h"
#include "cli/call/subcommand.h"
#include "recording/bus_recorder.h"
#include "recording/recording_trigger.h"

#include <array>

namespace codewheel {

// What a call of `record` asks for.
struct RecordWish
{
    RecordingPlan plan;
    std::set<Place> encoders{};        // that are recorded, as far as they are known
    std::optional<Instant> duration{}; // of --for

    // The file; or the address of the server.
    QString target() const;
    bool isOnServer() const { return !plan.settings.server.isEmpty(); }

    // As far as it can be told without the buses.
    static Checked<RecordWish> of(const Arguments &arguments);
};

inline constexpr std::array recordOptions{
    Option{"-o", "FILE",
           QT_TRANSLATE_NOOP("codewheel::CommandLine",
                             "the file to make, usually named .cwrec; there must be none of that name")},
    Option{
        "--to", "ADDRESS",
        QT_TRANSLATE_NOOP("codewheel::CommandLine",
                          "record on a PostgreSQL server instead: postgresql://[USER@]HOST[:PORT]/DATABASE; "
                          "passwords are in ~/.pgpass, PGPASSFILE or PGPASSWORD")},
    deviceOption,
    Option{"--for", "SECONDS",
           QT_TRANSLATE_NOOP("codewheel::CommandLine", "how long to record; without: until Ctrl+C")},
    Option{
        "--trigger", "TRIGGER",
        QT_TRANSLATE_NOOP("codewheel::CommandLine",
                          "wait for a bit (1.0/in.25, 1.0/in.25=0), a threshold in quotation marks "
                          "(\"1.0/position>1000\", \"1.0/speed<-50\") or a message (fault, 1.0/attention)")},
    Option{"--before", "SECONDS",
           QT_TRANSLATE_NOOP("codewheel::CommandLine", "also record what was before the trigger (0)")},
    Option{"--after", "SECONDS",
           QT_TRANSLATE_NOOP("codewheel::CommandLine",
                             "how long to record after the trigger; without: until Ctrl+C")},
    Option{"--last", "HOURS",
           QT_TRANSLATE_NOOP("codewheel::CommandLine", "keep the last hours only; what is older gives way")},
    Option{"--max-size", "MB",
           QT_TRANSLATE_NOOP("codewheel::CommandLine",
                             "the largest size of the file; then what is oldest gives way")},
    Option{"--keep-free", "MB",
           QT_TRANSLATE_NOOP("codewheel::CommandLine", "wait while the disk has less room for others (100)")},
    Option{"--no-traffic", nullptr,
           QT_TRANSLATE_NOOP("codewheel::CommandLine",
                             "only values and messages, without words and requests as they pass")},
};

// The trigger typed as `text` (recording/trigger_text.h). Its place is written as any PLACE, or is a bus; an
// encoder is asked so that it shows what the trigger waits for. Refused if it has no such bit.
Checked<RecordingTrigger> triggerMeant(const Call &call, const QString &text);

} // namespace codewheel
