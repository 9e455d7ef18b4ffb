// SPDX-License-Identifier: GPL-3.0-or-later
// The protocol of the tests' own kind (plain_node.h): added to those of the program by being linked, with the
// description of plain-node, whose module has three bytes of position.
#pragma once

#include "catalog/protocol_rules.h"
#include "vocabulary/event.h"

namespace codewheel::test {

inline constexpr Profile plainProfile{"plain"};

// "2000:1", may be negative.
Parameter plainFilter();
// "1008", a text.
Parameter plainName();

// What descriptions of encoders with such lines may contain.
class PlainLineRules : public ProtocolRules
{
public:
    bool hasParameters() const override { return true; }
    bool storesByStep() const override { return true; }
    std::int64_t smallestData() const override { return -0x8000'0000ll; }
    std::int64_t largestData() const override { return 0xFFFF'FFFFll; }
    bool hasTexts() const override { return true; }
    int positionBits(const DeviceDescription & /*device*/) const override { return 24; }
    void readReach(const JsonObject &row, ParameterDescription &parameter,
                   const DeviceDescription & /*before*/) const override
    {
        parameter.canBeRead = row.has("read");
        parameter.canBeWritten = row.has("write");
    }
    void checkParameter(const JsonObject & /*row*/, const ParameterDescription & /*parameter*/,
                        const DeviceDescription & /*device*/) const override
    {}
    ReachText reachText(const ParameterDescription &parameter) const override
    {
        const QString key = parameterKey(parameter.parameter);
        return {.write = parameter.canBeWritten ? key : QString(),
                .read = parameter.canBeRead ? key : QString()};
    }
};

struct PlainStep : Step
{
    enum class Task : std::uint8_t { get, set, go, keep, to, check, all, at };

    Task task = Task::get;
    ParameterValues values{}; // set, all: given; check: what has to be there
};

std::vector<PlainStep> plainSteps(const DeviceDescription &device, const Job &job);
PlainStep plainStore();
std::vector<PlainStep> plainWrites(const DeviceDescription &device, const ParameterValues &values);

// Its key, and its value as in a line, which has no spaces but those between values.
QByteArray plainKey(Parameter parameter);
QByteArray plainAssignment(const ParameterValue &value);
Value plainValue(const ParameterDescription &parameter, const QByteArray &text);

} // namespace codewheel::test
