// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "jobs/write_plan.h"

#include <QJsonArray>

namespace codewheel {

// What `write` is about to do, shown before anything is written: each value, what is known of it, and the
// word, or the command on a serial line, that will carry it; and the consequences.
QString writePlanText(const EncoderSession &encoder, const WritePlan &plan);
QJsonArray writePlanJson(const EncoderSession &encoder, const WritePlan &plan);
QJsonArray valueNotesJson(const std::vector<ValueNote> &notes); // [{"key", "arguments"}]

} // namespace codewheel
