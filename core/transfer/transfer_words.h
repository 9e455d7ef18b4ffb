// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "transfer/replacement.h"
#include "transfer/transfer_account.h"

#include <QStringList>

namespace codewheel {

// Transfers in words, for window, command line and report alike.
namespace transfer_words {

// "Written, and read back", "Already there".
QString became(const AccountRow &row);
QString became(const AccountCamRow &row);
// Of the position that was to be set: "Set", "Not done"
QString becameOfPosition(const EncoderAccount &account);
// "8 192 (read)"; "unknown"
QString known(const DeviceDescription *device, Parameter parameter, const std::optional<Known> &known);
// "8 192", without unit; `device` may be null.
QString value(const DeviceDescription *device, const ParameterValue &value);
// "in operation"
QString leftIn(EncoderState state);
// With what OUT may still hold.
QString leftIn(const EncoderAccount &account);

// What is worth knowing before an encoder is written to, one sentence each.
QStringList notes(const EncoderPlan &plan);
// In short: "5 values to write, at most 6 EEPROM writes", "All is there", or the hindrance.
QString summary(const EncoderPlan &plan);
// The result: "Done.", "Not begun.", or why not.
QString outcome(const EncoderAccount &account);

QStringList differences(const ReplacementDifferences &differences, const Replacement &now);

} // namespace transfer_words

} // namespace codewheel
