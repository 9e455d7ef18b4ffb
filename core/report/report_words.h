// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/reported_device.h"

// How the report puts values, times and devices into words; used by all of its sections.
namespace codewheel::report_words {

// "1 Mar 2026 14:02", by locale, the year with four digits, in the time zone of `now`.
QString time(const QDateTime &at, const QDateTime &now);
// "FRABA OCD-IB K3", "device not known"; a key without a description is shown as it is.
QString device(const ReportedDevice &device);
// Without unit, "3 (CW)".
QString value(const ReportedDevice &device, Parameter parameter, const Value &value);
QString unit(const ReportedDevice &device, Parameter parameter);
// As serialNumberText(). Anything else is shown as it is.
QString serialNumber(const QString &decimal);
// As typed from a label. With letters, or where `read` is this number, it is hexadecimal; of digits alone
// nobody knows.
QString serialNumberOfLabel(const QString &typed, std::optional<std::int64_t> read);
QString unknown();
// Why it is of before, and of when: "The bus does not run. Last seen: 1 Mar 2026 14:02."
QString lastSeen(const NotLive &old, const QDateTime &now);

} // namespace codewheel::report_words
