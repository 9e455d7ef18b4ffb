// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/total_range.h"
#include "catalog/value_text.h"
#include "jobs/planned_by.h"
#include "jobs/protocol.h"
#include "jobs/value_notes.h"
#include "jobs/values_to_write.h"
#include "kinds/canopen/canopen_protocols.h"
#include "kinds/canopen/driver/node_plan.h"
#include "kinds/canopen/protocol/canopen_reach.h"
#include "kinds/canopen/protocol/encoder_objects.h"
#include "vocabulary/enumeration_rows.h"
#include "vocabulary/sentence.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace codewheel {
namespace {

using StepTask = canopen::NodeStep::Task;

struct StepTexts
{
    Q_DECLARE_TR_FUNCTIONS(CanopenStep)
};

// Those of which the line says less than is meant.
constexpr auto stepTextRows = std::to_array<TextOf<StepTask>>({
    {StepTask::bits, QT_TRANSLATE_NOOP("CanopenStep", "read %1, of which other bits stay as they are")},
    {StepTask::readBack, QT_TRANSLATE_NOOP("CanopenStep", "read %1 back")},
    {StepTask::store, QT_TRANSLATE_NOOP("CanopenStep", "store what is in force (%1 := \"save\")")},
    {StepTask::restore, QT_TRANSLATE_NOOP("CanopenStep", "restore the factory values (%1 := \"load\")")},
    {StepTask::started, QT_TRANSLATE_NOOP("CanopenStep", "wait until the node runs again")},
    {StepTask::bootUp, QT_TRANSLATE_NOOP("CanopenStep", "wait until the node reports again")},
});

constexpr auto commandTextRows = std::to_array<TextOf<canopen::NmtCommand>>({
    {canopen::NmtCommand::start, QT_TRANSLATE_NOOP("CanopenStep", "start the node")},
    {canopen::NmtCommand::stop, QT_TRANSLATE_NOOP("CanopenStep", "stop the node")},
    {canopen::NmtCommand::preOperational, QT_TRANSLATE_NOOP("CanopenStep", "node to pre-operational")},
    {canopen::NmtCommand::resetNode, QT_TRANSLATE_NOOP("CanopenStep", "reset the node")},
    {canopen::NmtCommand::resetCommunication,
     QT_TRANSLATE_NOOP("CanopenStep", "reset the communication of the node")},
});

// "6001h:0" of "6001:0=5000".
QString objectTextOf(const QByteArray &line)
{
    constexpr int hexadecimal = 16;
    const qsizetype colon = line.indexOf(':');
    const QByteArray sub = line.mid(colon + 1);
    const auto end = std::ranges::find_if(sub, [](char c) { return c == '=' || c == ' '; });
    return canopen::SdoObject{static_cast<std::uint16_t>(line.left(colon).toUInt(nullptr, hexadecimal)),
                              static_cast<std::uint8_t>(sub.left(end - sub.begin()).toUInt())}
        .text();
}

QString commandText(const QByteArray &line)
{
    const int number = line.mid(line.indexOf(' ') + 1).toInt();
    const auto row = std::ranges::find(commandTextRows, static_cast<canopen::NmtCommand>(number),
                                       &TextOf<canopen::NmtCommand>::id);
    return row != commandTextRows.end() ? StepTexts::tr(row->text) : QString::fromLatin1(line);
}

class CanopenProtocol final : public Protocol
{
public:
    Result<std::vector<Step>> planned(const DeviceDescription &device, const Job &job,
                                      const PlanBasis &basis) const override
    {
        const canopen::NodePlan plan(device, valuesOf(basis.known),
                                     basis.cams.empty() ? std::nullopt : std::optional(basis.cams.front()));
        return plannedBy(plan, job, [&] { return plan.stepsFor(job); });
    }
    QString stepText(const DeviceDescription &device, const Step &step) const override;
    QString presetCommand() const override { return canopen::object::preset.text(); }
    ParameterValues valuesIn(const DeviceDescription &device, const Step &step) const override;
    QString howItIsSent() const override
    {
        return QCoreApplication::translate("Protocol",
                                           "Each command is sent once, and what was written is read back.");
    }
    bool wasSent(const Progress &job, std::optional<Parameter> parameter) const override;
    ParameterDescription narrowed(const DeviceDescription &device, Parameter parameter,
                                  const ParameterValues &known, const KindData &options) const override;
    std::optional<PositionScale> scaleOf(const DeviceDescription &device,
                                         const ValueOf &valueOf) const override;
    std::optional<Parameter> presetOffset() const override { return Parameter::offset; }
};

QString CanopenProtocol::stepText(const DeviceDescription &device, const Step &step) const
{
    const StepTask task = step.kind.as<StepTask>();
    if (task == StepTask::nmt)
        return commandText(step.line);
    const QString object = objectTextOf(step.line);
    const auto row = std::ranges::find(stepTextRows, task, &TextOf<StepTask>::id);
    if (row != stepTextRows.end())
        return sentence(StepTexts::tr(row->text), {object});
    QStringList names;
    for (const Parameter parameter : step.parameters)
        names << parameterNameInText(device, parameter);
    const QString name =
        names.isEmpty() ? QString() : QStringLiteral(", ") + names.join(QStringLiteral(", "));
    if (step.effect == Effect::reads || step.effect == Effect::readsCams)
        return sentence(StepTexts::tr("read %1"), {object + name});
    const ParameterValues values = valuesIn(device, step);
    if (values.empty())
        return sentence(QStringLiteral("%1 := %2"), {object, numberText(step.data.value_or(0))});
    QStringList given;
    for (const ParameterValue &value : values) {
        const ParameterDescription *its = device.find(value.parameter);
        given << parameterNameInText(device, value.parameter) + QStringLiteral(" := ") +
                     (its != nullptr ? valueText(*its, value.value) : plainText(value.value));
    }
    return QStringLiteral("%1, %2").arg(object, given.join(QStringLiteral(", ")));
}

// Of bits the line has one after the other, in the order of their parameters.
ParameterValues CanopenProtocol::valuesIn(const DeviceDescription &device, const Step &step) const
{
    if (step.data || step.parameters.empty() || !step.line.contains('='))
        return Protocol::valuesIn(device, step);
    const ParameterDescription *first = device.find(step.parameters.front());
    if (first != nullptr && first->isText())
        return {{first->parameter, Value(QString::fromUtf8(step.line.mid(step.line.indexOf('=') + 1)))}};
    ParameterValues values;
    const auto bits = step.line.split(' ').sliced(1);
    for (std::size_t i = 0; i < step.parameters.size() && i < static_cast<std::size_t>(bits.size()); ++i) {
        const QByteArray &bit = bits.at(static_cast<qsizetype>(i));
        values.push_back({step.parameters[i], bit.mid(bit.indexOf('=') + 1).toInt()});
    }
    return values;
}

bool CanopenProtocol::wasSent(const Progress &job, std::optional<Parameter> parameter) const
{
    const auto begun =
        std::span(job.steps).first(std::min(job.steps.size(), static_cast<std::size_t>(job.index) + 1));
    return std::ranges::any_of(begun, [parameter](const Step &step) {
        return parameter ? takesValue(step) && std::ranges::count(step.parameters, *parameter) > 0
                         : step.effect == Effect::setsPosition;
    });
}

// While it is scaled, the position lies within the measuring range.
ParameterDescription CanopenProtocol::narrowed(const DeviceDescription &device, Parameter parameter,
                                               const ParameterValues &known, const KindData &options) const
{
    ParameterDescription narrowed = Protocol::narrowed(device, parameter, known, options);
    const auto range = valueOf(known, Parameter::measuringRange);
    const bool isScaled = scalingState(device, valueOf(known, Parameter::scaling)) == ScalingState::on;
    if (parameter == Parameter::preset && range && isScaled && *range >= narrowed.minimum)
        narrowed.maximum = std::min(narrowed.maximum, *range);
    return narrowed;
}

// While it is not scaled, it counts the steps of its disc, which it tells (6501h, 6502h). Some makes give
// the highest position as range, one less than there are.
std::optional<PositionScale> CanopenProtocol::scaleOf(const DeviceDescription &device,
                                                      const ValueOf &valueOf) const
{
    const ScalingState scaling = scalingState(device, valueOf(Parameter::scaling));
    const auto direction = valueOf(Parameter::direction);
    if (canopenDevice(device).isLinear || scaling == ScalingState::unknown ||
        (device.find(Parameter::direction) != nullptr && !direction))
        return std::nullopt;
    const auto told = [&](Parameter parameter, int described) {
        return valueOf(parameter).value_or(described);
    };
    PositionScale scale;
    scale.physicalStepsPerTurn = told(Parameter::of(u"6501"), device.physicalStepsPerTurn);
    scale.physicalTurns = told(Parameter::of(u"6502"), device.physicalTurns);
    scale.steps = scale.physicalStepsPerTurn;
    scale.turns = scale.physicalTurns;
    if (scaling == ScalingState::on) {
        scale.steps = valueOf(Parameter::steps).value_or(0);
        std::int64_t range = valueOf(Parameter::measuringRange).value_or(0);
        if (scale.steps > 1 && (range + 1) % scale.steps == 0)
            ++range;
        scale.turns = scale.steps > 0 && range % scale.steps == 0 ? range / scale.steps : 0;
    }
    if (scale.steps < 1 || scale.turns < 1)
        return std::nullopt;
    scale.clockwise = !direction || countsClockwise(device, {Parameter::direction, *direction});
    return scale;
}

} // namespace

const Protocol &canopenProtocol()
{
    static const CanopenProtocol protocol;
    return protocol;
}

} // namespace codewheel
