// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/cams/cam_drag.h"
#include "widgets/cams/cam_sheet.h"

#include <QString>

// How ruler, table and screen readers describe a cam, in the same words.
namespace codewheel::cam_texts {

QString position(std::int64_t position); // by locale
QString name(std::size_t cam);           // "Cam 3"
// "21 to 531"; "33 000 000 to 4 000, through zero"
QString range(const Cam &cam);
QString activity(const Cam &cam); // "active", "inactive"
QString state(std::optional<bool> isOn, bool isTold);
// The name of an undo step: "Move cam 3", "Start of cam 3"
QString movement(std::size_t cam, CamGrip grip);
// The full description, for tooltips and screen readers.
QString description(const CamSheet &sheet, std::size_t cam);

} // namespace codewheel::cam_texts
