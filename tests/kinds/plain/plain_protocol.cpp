// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/kinds/plain/plain_protocol.h"

#include "catalog/json_object.h"
#include "catalog/value_text.h"
#include "jobs/job_check.h"
#include "jobs/planned_by.h"
#include "jobs/protocol.h"

#include <algorithm>

namespace codewheel::test {
namespace {

constexpr std::size_t valuesOfALine = 3;

enum class Module : std::uint8_t { twoBytes, threeBytes };

class PlainRules final : public PlainLineRules
{
public:
    bool activatesByRun() const override { return true; }
    bool presetsByCommand() const override { return true; }
    int positionBits(const DeviceDescription &device) const override
    {
        return device.dialect.as<Module>() == Module::threeBytes ? 24 : 16;
    }
    void readDialect(const JsonObject &json, DeviceDescription &device) const override
    {
        constexpr NamedValue<Module> modules[] = {{"P16", Module::twoBytes}, {"P24", Module::threeBytes}};
        device.dialect = json.oneOf("dialect", modules);
    }
};

class PlainProtocol final : public Protocol
{
public:
    Result<std::vector<Step>> planned(const DeviceDescription &device, const Job &job,
                                      const PlanBasis & /*basis*/) const override
    {
        if (const auto checked = checkJob(device, job); !checked)
            return tl::unexpected(checked.error());
        const auto steps = plainSteps(device, job);
        return std::vector<Step>(steps.begin(), steps.end());
    }
    QString presetCommand() const override { return QStringLiteral("to"); }
};

PlainStep step(PlainStep::Task task, Effect effect, const QByteArray &line)
{
    PlainStep step;
    step.task = task;
    step.effect = effect;
    step.line = line;
    return step;
}

PlainStep reading(PlainStep::Task task, Parameter parameter)
{
    PlainStep made = step(task, Effect::reads, "get " + plainKey(parameter));
    made.parameters = {parameter};
    return made;
}

} // namespace

Parameter plainFilter()
{
    return Parameter::of(u"2000:1");
}

Parameter plainName()
{
    return Parameter::of(u"1008");
}

QByteArray plainKey(Parameter parameter)
{
    return parameterKey(parameter).toLatin1();
}

QByteArray plainAssignment(const ParameterValue &value)
{
    const QString text = value.value.toString();
    return plainKey(value.parameter) + '=' +
           (value.value.isText() ? text.toUtf8().toPercentEncoding() : text.toLatin1());
}

Value plainValue(const ParameterDescription &parameter, const QByteArray &text)
{
    return parameter.isText() ? Value(QString::fromUtf8(QByteArray::fromPercentEncoding(text)))
                              : Value(text.toLongLong());
}

PlainStep plainStore()
{
    return step(PlainStep::Task::keep, Effect::stores, "keep");
}

std::vector<PlainStep> plainWrites(const DeviceDescription &device, const ParameterValues &values)
{
    std::vector<PlainStep> steps;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (i % valuesOfALine == 0)
            steps.push_back(step(PlainStep::Task::set, Effect::takes, "set"));
        PlainStep &line = steps.back();
        line.line += ' ' + plainAssignment(values[i]);
        line.parameters.push_back(values[i].parameter);
        line.values.push_back(values[i]);
    }
    if (values.empty())
        return steps;
    steps.push_back(step(PlainStep::Task::go, Effect::activates, "go"));
    steps.push_back(plainStore());
    for (const ParameterValue &value : values)
        if (device.find(value.parameter)->canBeRead) {
            steps.push_back(reading(PlainStep::Task::check, value.parameter));
            steps.back().values = {value};
        }
    return steps;
}

std::vector<PlainStep> plainSteps(const DeviceDescription &device, const Job &job)
{
    std::vector<PlainStep> steps;
    if (const auto *read = std::get_if<ReadParameters>(&job))
        for (const Parameter parameter : read->parameters)
            steps.push_back(reading(PlainStep::Task::get, parameter));
    if (const auto *write = std::get_if<WriteParameters>(&job)) {
        for (const ParameterValue &value : write->values)
            if (write->onlyWhatDiffers && device.find(value.parameter)->canBeRead)
                steps.push_back(reading(PlainStep::Task::get, value.parameter));
        std::ranges::copy(plainWrites(device, write->values), std::back_inserter(steps));
    }
    if (const auto *preset = std::get_if<SetPreset>(&job))
        steps.push_back(step(PlainStep::Task::to, Effect::setsPosition,
                             "to " + QByteArray::number(static_cast<qlonglong>(preset->value.value_or(0)))));
    return steps;
}

namespace {

// Before anybody reads the built-in descriptions, among which is that of plain-node.
const bool isAdded = [] {
    static const PlainRules rules;
    static const PlainProtocol protocol;
    addProtocol({plainProfile, rules, protocol});
    return true;
}();

} // namespace

} // namespace codewheel::test
