// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/kinds/plain/telegram_protocol.h"

#include "jobs/job_check.h"
#include "jobs/protocol.h"
#include "jobs/value_notes.h"
#include "tests/kinds/plain/plain_run.h"

namespace codewheel::test {
namespace {

class TelegramProtocol final : public Protocol
{
public:
    Result<std::vector<Step>> planned(const DeviceDescription &device, const Job &job,
                                      const PlanBasis &basis) const override
    {
        if (const auto checked = checkJob(device, job); !checked)
            return tl::unexpected(checked.error());
        const auto steps = telegramSteps(device, job, valuesOf(basis.known));
        return std::vector<Step>(steps.begin(), steps.end());
    }
    ParameterValues valuesIn(const DeviceDescription &device, const Step &step) const override
    {
        ParameterValues values;
        const auto texts = step.line.split(' ').sliced(1);
        for (std::size_t i = 0; i < step.parameters.size(); ++i) {
            const QByteArray text = texts.at(static_cast<qsizetype>(i));
            const Parameter parameter = step.parameters[i];
            values.push_back(
                {parameter, plainValue(*device.find(parameter), text.mid(text.indexOf('=') + 1))});
        }
        return values;
    }
    bool goesAlong(Parameter /*parameter*/, const ParameterValues &written) const override
    {
        return !written.empty();
    }
};

Value valueFor(const ParameterDescription &parameter, const ParameterValues &wanted,
               const ParameterValues &known)
{
    if (const auto value = findValue(wanted, parameter.parameter))
        return *value;
    if (const auto value = findValue(known, parameter.parameter))
        return *value;
    return parameter.isText() ? Value(QString()) : Value(parameter.factory.value_or(0));
}

} // namespace

std::vector<PlainStep> telegramSteps(const DeviceDescription &device, const Job &job,
                                     const ParameterValues &known)
{
    const auto *write = std::get_if<WriteParameters>(&job);
    if (write == nullptr)
        return {};
    PlainStep all;
    all.task = PlainStep::Task::all;
    all.effect = Effect::takes;
    all.line = "all";
    for (const ParameterDescription &its : device.parameters) {
        all.values.push_back({its.parameter, valueFor(its, write->values, known)});
        all.parameters.push_back(its.parameter);
        all.line += ' ' + plainAssignment(all.values.back());
    }
    PlainStep at; // only its answer tells that the encoder works with them
    at.task = PlainStep::Task::at;
    at.effect = Effect::reads;
    at.line = "at";
    return {all, at};
}

void takeTelegramPosition(const QByteArray &answer, PlainKnowledge &encoder)
{
    Reading &reading = encoder.reading;
    if (answer.startsWith("at ")) {
        reading.state = EncoderState::operation;
        reading.position = answer.mid(3).toLongLong();
        return;
    }
    reading.state = EncoderState::waiting;
    reading.position.reset();
    for (const ParameterDescription &its : encoder.device.parameters)
        encoder.values.forget(its.parameter);
    encoder.flush();
}

namespace {

const bool isTelegramAdded = [] {
    static const PlainLineRules rules;
    static const TelegramProtocol protocol;
    addProtocol({telegramProfile, rules, protocol});
    return true;
}();

} // namespace

} // namespace codewheel::test
