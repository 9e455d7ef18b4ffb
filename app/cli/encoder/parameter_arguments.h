// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "cli/call/complaint.h"

#include <QStringList>

namespace codewheel {

class Catalog;

// The parameters named, checked against what can be read from the device; each once.
Checked<std::vector<Parameter>> parametersToRead(const DeviceDescription &device, const QStringList &names);

// "steps=255", "direction=cw": the values in the order given. Ranges are the driver's to check.
Checked<ParameterValues> valuesToWrite(const DeviceDescription &device, const QStringList &assignments);

// A value as the user types it: a text, a number, or the key of a choice.
Checked<Value> valueFrom(const ParameterDescription &parameter, const QString &text);
Checked<std::int64_t> numberFrom(const ParameterDescription &parameter, const QString &text);

// The device with this key; the complaint lists the existing keys.
Checked<const DeviceDescription *> deviceNamed(const Catalog &catalog, const QString &key);
// A process-data word: up to eight hexadecimal digits, as the manuals print them.
Checked<Word> wordFrom(const QString &text);

} // namespace codewheel
