// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "vocabulary/cam_program.h"
#include "vocabulary/refusal.h"

#include <QByteArray>

#include <optional>

namespace codewheel {

inline constexpr qint64 largestCamFile = 1'000'000; // bytes; eight programs take 8 000

// Cam programs as kept in a file (docs/cam-files.md): for which kind of encoder, with how many positions.
// Disk access is up to the caller.
struct CamFile
{
    QString device;                         // key of the device description
    std::optional<std::int64_t> totalRange; // in steps; empty: not known
    std::vector<CamProgram> programs;       // at least one

    friend bool operator==(const CamFile &, const CamFile &) = default;
};

// The same programs always give the same bytes: by number, each with its eight cams.
QByteArray camFileToJson(CamFile file);

// Rejects the file as a whole if it breaks a rule: camFileBroken. `name` is the file's, for the sentence. No
// position may be above the total range of the file, nor above `largestPosition` of the encoder.
Result<CamFile> camFileFromJson(const QByteArray &json, const QString &name,
                                std::optional<std::int64_t> largestPosition = {});

// The one program wanted, 1..8: camFileOfOtherProgram if the file holds only others.
Result<CamProgram> camProgramOf(const CamFile &file, unsigned number, const QString &name);

// Whether the programs are for this encoder. `madeFor` is the description of the file's device, null if there
// is none: an encoder takes what was made for another one of its profile with the same cams.
bool suits(const CamFile &file, const DeviceDescription &encoder, const DeviceDescription *madeFor);
// Why they are not accepted, in the user's language.
QString otherDeviceText(const CamFile &file, const DeviceDescription &encoder, const QString &name);

} // namespace codewheel
