// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "can/can_log_clock.h"

#include <QJsonObject>
#include <QStringList>

namespace codewheel {

// A frame as `frames` tells it: time, identifier, data, and what they mean.
QStringList frameCells(const CanFrame &frame, const QString &meaning, bool isSince1970);
QJsonObject frameJson(const CanFrame &frame, const QString &meaning);

// "absolute", as --times takes it.
QString timesKey(CanLogTimes times);
// What the times of a log are, as a sentence. Empty: no frame has one.
QString timesText(std::optional<CanLogTimes> times, bool isSince1970);

} // namespace codewheel
