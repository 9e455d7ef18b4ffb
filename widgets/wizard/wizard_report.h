// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "jobs/value_notes.h"
#include "report/report.h"
#include "widgets/wizard/handshake_record.h"

namespace codewheel {

// The report of a handshake, in the user's language: device, date, old and new values with their evidence,
// the words with the encoder's answers, EEPROM writes, position before and after, program version.
Report reportOf(const HandshakeRecord &record, const DeviceDescription &device, const QString &version);

// How the new values were verified: read back, or echoed and run.
QString verificationText(const HandshakeRecord &record, const DeviceDescription &device);
// That the values of the scaling do not act, or may not; empty: they do.
std::optional<ValueNote> unscaledNote(const HandshakeRecord &record, const DeviceDescription &device);

} // namespace codewheel
