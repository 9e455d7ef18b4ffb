// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/reading.h"
#include "widgets/look/roles.h"

#include <QString>

namespace codewheel {

struct DeviceDescription;
class EncoderSession;

// What a dial says about an encoder that is not in operation, or whose reading is old.
struct StateNote
{
    QString sentence;
    Role role = Role::attention;
};
StateNote noteOfState(const DeviceDescription &device, const Reading &reading);
StateNote noteOfAge(const EncoderSession &encoder);
// Of a recording: what it says besides that, if anything.
StateNote noteOfRecording(const EncoderSession &encoder, const StateNote &then);

// Why an encoder shows no position, and what to do about it; empty where it shows one.
QString whyNoPosition(const EncoderSession &encoder);

} // namespace codewheel
