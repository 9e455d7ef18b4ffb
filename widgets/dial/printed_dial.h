// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/known.h"
#include "widgets/look/printed_view.h"

#include <span>

namespace codewheel {

class EncoderSession;

// A dial as it is printed: its picture, what the picture tells, and what is known of `parameters`.
PrintedView printedDial(const EncoderSession &encoder, PrintedPicture picture,
                        std::vector<std::pair<QString, QString>> values,
                        std::span<const Parameter> parameters);

} // namespace codewheel
