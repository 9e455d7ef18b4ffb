// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/parameter.h"

#include <QByteArray>

#include <optional>

namespace codewheel {

class EncoderSession;

// What has to be known of a device to say what its recorded values mean.
struct RecordedDevice
{
    QString key{};        // of its description
    QString name{};       // in full, in case the description is not there
    int turns = 0;        // physical, from the label or the description; 0: not known
    int stepsPerTurn = 0; // physical
    ParameterValues known{};

    friend bool operator==(const RecordedDevice &, const RecordedDevice &) = default;
};

RecordedDevice recordedDevice(const EncoderSession &encoder);

// As the recording has it (docs/recording-files.md, "Tables"). What is not understood when it is read is left
// out.
QByteArray toJson(const RecordedDevice &device);
RecordedDevice recordedDeviceFromJson(const QByteArray &json);

} // namespace codewheel
