// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/call/subcommand.h"
#include "kinds/canopen/eds/device_file.h"

#include <QJsonArray>

namespace codewheel {

// By its name: EDS or DCF.
bool isCanopenDeviceFile(const QString &path);
// Refused, with line and key, if it is none, or cannot be read.
Checked<canopen::DeviceFile> canopenDeviceFile(const QString &path);

// For `devices --check`: what the file says.
Answer checkOfDeviceFile(const Call &call, const QString &path);

// Its objects, one row each.
QString fileObjectLines(const canopen::DeviceFile &file);
QJsonArray fileObjectsJson(const canopen::DeviceFile &file);

// Of what was refused in it: line, key and sentence.
Complaint complaintAboutDeviceFile(const QString &path, const canopen::EdsNote &why);
QJsonValue fileValueJson(const std::optional<canopen::FileValue> &value,
                         std::optional<canopen::DataType> type);
QString fileValueText(const std::optional<canopen::FileValue> &value, std::optional<canopen::DataType> type);
// For standard error.
void complainOfNotes(const Terminal &terminal, const canopen::EdsNotes &notes);

// Makes a description of the device in the user's folder, by which it is known from then on.
Checked<Answer> importDeviceFile(const Call &call, const QString &path, const canopen::DeviceFile &file);

} // namespace codewheel
