// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "history/track.h"
#include "recording/bus_recorder.h"

#include <QDateTime>

#include <functional>

namespace codewheel {

// What can be recorded, as the dialog shows it.
struct RecordableEncoder
{
    Place place;
    QString name; // "1.0  Hoist"
    QString what; // "FRABA OCD-IB K3"
    bool hasWords = false;
    bool hasCams = false;
    std::vector<TrackScale>
        scales{}; // of its positions and speeds, at least in steps; that of the trend first
};

struct RecordingSubjects
{
    std::vector<RecordableEncoder> encoders;
    std::vector<std::pair<BusId, QString>> buses;
    QDateTime now; // for the name of the file
    // Of these encoders, or, if there are none, of all; nothing: not known.
    std::function<std::optional<double>(const std::set<Place> &places, bool withTraffic)> bytesPerSecond;
    std::function<Result<void>(const RecordingPlan &plan)> begin;
};

} // namespace codewheel
