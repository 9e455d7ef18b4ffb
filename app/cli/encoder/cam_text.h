// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cams/cam_fields.h"
#include "catalog/device_description.h"

#include <QJsonArray>
#include <QString>

#include <vector>

namespace codewheel {

// A value in which the encoder differs from the wanted program.
struct CamDifference
{
    unsigned program = 1;
    CamField field;
    std::int64_t encoder = 0;
    std::int64_t wanted = 0;
    Word word = 0; // that sets it
};

// `has` and `wanted` are programs with the same numbers.
std::vector<CamDifference> differencesOf(const DeviceDescription &device, const std::vector<CamProgram> &has,
                                         const std::vector<CamProgram> &wanted);

// Program by program, a row for each cam.
QString camTable(const std::vector<CamProgram> &programs);
// A row for each value, with the word that sets it.
QString differenceTable(const std::vector<CamDifference> &differences);

QJsonArray camsJson(const std::vector<CamProgram> &programs);
QJsonArray differencesJson(const std::vector<CamDifference> &differences);

} // namespace codewheel
