// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/instant.h"

#include <QLocale>

namespace codewheel {

// As one says it: "40 s", "12 min", "1 h 48 min", "3 d 4 h".
QString roughDurationText(Instant duration, const QLocale &locale);

} // namespace codewheel
