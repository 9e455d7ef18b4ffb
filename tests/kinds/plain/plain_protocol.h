// SPDX-License-Identifier: GPL-3.0-or-later
// The protocol of the tests' own kind (plain_node.h): added to those of the program by being linked, with the
// description of plain-node, whose module has three bytes of position.
#pragma once

#include "catalog/device_description.h"
#include "vocabulary/event.h"

namespace codewheel::test {

inline constexpr Profile plainProfile{"plain"};

// "2000:1", may be negative.
Parameter plainFilter();
// "1008", a text.
Parameter plainName();

struct PlainStep : Step
{
    enum class Task : std::uint8_t { get, set, go, keep, to, check };

    Task task = Task::get;
    ParameterValues values{}; // set: given; check: what has to be there
};

std::vector<PlainStep> plainSteps(const DeviceDescription &device, const Job &job);
std::vector<PlainStep> plainWrites(const DeviceDescription &device, const ParameterValues &values);

// Its key, and its value as in a line.
QByteArray plainKey(Parameter parameter);
Value plainValue(const ParameterDescription &parameter, const QByteArray &text);

} // namespace codewheel::test
