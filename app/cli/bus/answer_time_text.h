// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/answer_times.h"

#include <QJsonValue>
#include <QString>

namespace codewheel {

// How long the answers on a link have taken, for its statistics: a line; empty if there was none.
QString answerTimeText(const std::optional<AnswerTime> &time);
QJsonValue answerTimeJson(const std::optional<AnswerTime> &time); // in microseconds; null: there was none

// A number of the statistics.
QString countText(std::uint64_t count);
QJsonValue countJson(std::uint64_t count);

} // namespace codewheel
