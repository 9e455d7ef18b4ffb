// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "encoder/cam_program.h"
#include "encoder/refusal.h"

#include <QByteArray>

#include <optional>

namespace codewheel {

inline constexpr qint64 largestCamFile = 1'000'000; // bytes; eight programs take 8 000

// Cam programs as they are kept in a file (docs/cam-files.md): for which kind of encoder, with how many
// positions. Reading and writing the disk is the caller's.
struct CamFile
{
    QString device;                         // key of the device description
    std::optional<std::int64_t> totalRange; // in steps; nothing: was not known
    std::vector<CamProgram> programs;       // at least one

    friend bool operator==(const CamFile &, const CamFile &) = default;
};

// The same programs always give the same bytes: by number, each with its eight cams.
QByteArray camFileToJson(CamFile file);

// Refuses what breaks a rule, as a whole: camFileBroken. `name` is the file's, for the sentence. No position
// may be above the total range of the file, nor above `largestPosition` of the encoder.
Result<CamFile> camFileFromJson(const QByteArray &json, const QString &name,
                                std::optional<std::int64_t> largestPosition = {});

// The one program wanted, 1..8: camFileOfOtherProgram where the file holds others only.
Result<CamProgram> camProgramOf(const CamFile &file, unsigned number, const QString &name);

// Whether the programs are for this encoder. `madeFor` is the description of the file's device, null where
// there is none: an encoder takes what was made for another of its profile with the same cams.
bool suits(const CamFile &file, const DeviceDescription &encoder, const DeviceDescription *madeFor);
// Why they are not taken, in the user's language.
QString otherDeviceText(const CamFile &file, const DeviceDescription &encoder, const QString &name);

} // namespace codewheel
