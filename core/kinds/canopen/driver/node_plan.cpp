// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/driver/node_plan.h"

#include "cams/check_cams.h"
#include "jobs/job_check.h"
#include "jobs/protocol.h"
#include "kinds/canopen/protocol/canopen_reach.h"
#include "kinds/canopen/protocol/encoder_objects.h"

#include <algorithm>
#include <array>
#include <map>

namespace codewheel::canopen {
namespace {

using Task = NodeStep::Task;

constexpr std::int64_t largestSigned = 0x7FFF'FFFF; // a cam limit
constexpr std::array positionValues{Parameter::steps, Parameter::measuringRange, Parameter::measuringLength,
                                    Parameter::direction, Parameter::scaling};

QByteArray objectText(SdoObject object)
{
    return QByteArray::number(object.index, 16) + ':' + QByteArray::number(object.sub);
}

NodeStep stepOf(Task task, Effect effect, SdoObject object)
{
    NodeStep step;
    step.task = task;
    step.kind = task;
    step.effect = effect;
    step.object = object;
    step.line = objectText(object);
    return step;
}

NodeStep sending(Task task, Effect effect, SdoObject object, std::int64_t number)
{
    NodeStep step = stepOf(task, effect, object);
    step.number = static_cast<std::uint32_t>(number);
    step.data = number;
    step.line += '=' + QByteArray::number(qlonglong{number});
    return step;
}

// Those of a value come in the order of the parameter, those of its object together.
using ByObject = std::vector<std::pair<CanopenReach, ParameterValues>>;

int turnOf(const ParameterValues &together)
{
    enum { scalingOff, resolution, range, scalingOn, others };
    const auto scaling = valueOf(together, Parameter::scaling);
    if (scaling)
        return *scaling == 0 ? scalingOff : scalingOn;
    if (valueOf(together, Parameter::steps))
        return resolution;
    if (valueOf(together, Parameter::measuringRange) || valueOf(together, Parameter::measuringLength))
        return range;
    return others;
}

struct CamRow
{
    CamValue value;
    std::uint16_t index;
};
constexpr std::array camRows{
    CamRow{CamValue::start, 0x6310},      CamRow{CamValue::stop, 0x6320},
    CamRow{CamValue::hysteresis, 0x6330}, CamRow{CamValue::invertedCams, 0x6302},
    CamRow{CamValue::activeCams, 0x6301},
};

} // namespace

bool isOfPosition(Parameter parameter)
{
    return std::ranges::find(positionValues, parameter) != positionValues.end();
}

SdoObject camObject(CamField field)
{
    const auto row = std::ranges::find(camRows, field.value, &CamRow::value);
    return {static_cast<std::uint16_t>(row->index + field.cam), 1};
}

// A cam is enabled when the rest of it is there.
std::vector<CamField> camFieldsOf(const CamAbilities &cams)
{
    std::vector<CamField> fields;
    for (unsigned cam = 0; cam < cams.cams; ++cam) {
        fields.push_back({CamValue::start, cam});
        fields.push_back({CamValue::stop, cam});
        if (cams.hasHysteresis)
            fields.push_back({CamValue::hysteresis, cam});
    }
    if (cams.hasPolarity)
        fields.push_back({CamValue::invertedCams});
    fields.push_back({CamValue::activeCams});
    return fields;
}

Result<void> NodePlan::check(const Job &job) const
{
    if (auto checked = checkJob(m_device, job); !checked)
        return checked;
    const auto narrowed = [&](Parameter parameter, const ParameterValues &known) {
        return protocolOf(m_device).narrowed(m_device, parameter, known, {});
    };
    if (const auto *write = std::get_if<WriteParameters>(&job)) {
        ParameterValues known = m_known;
        for (const ParameterValue &value : write->values)
            replaceValue(known, value);
        for (const ParameterValue &value : write->values)
            if (const auto its = narrowed(value.parameter, known); !its.isText())
                if (auto checked = checkRange(its, value.value); !checked)
                    return checked;
    }
    if (const auto *preset = std::get_if<SetPreset>(&job))
        return checkRange(narrowed(Parameter::preset, m_known), *preset->value);
    if (const auto *read = std::get_if<ReadCams>(&job))
        for (const unsigned program : read->programs)
            if (auto checked = checkCamProgramNumber(program, *m_device.capabilities.cams); !checked)
                return checked;
    if (const auto *cams = std::get_if<WriteCams>(&job))
        for (const CamProgram &program : cams->programs)
            if (auto checked = codewheel::check(program, *m_device.capabilities.cams, largestSigned);
                !checked)
                return checked;
    if (std::holds_alternative<SwitchMode>(job) || std::holds_alternative<EndParameterization>(job))
        return refuse(RefusalKind::notSupported, RefusalId::jobNotSupported, {m_device.fullName()});
    return {};
}

NodeSteps NodePlan::stepsFor(const Job &job) const
{
    return std::visit(
        [this](const auto &one) {
            if constexpr (requires { steps(one); })
                return steps(one);
            else
                return NodeSteps();
        },
        job);
}

NodeSteps NodePlan::steps(const ReadParameters &job) const
{
    NodeSteps made;
    appendReads(made, Task::read, job.parameters);
    return made;
}

NodeSteps NodePlan::steps(const WriteParameters &job) const
{
    NodeSteps made;
    std::vector<Parameter> compared;
    for (const ParameterValue &value : job.values)
        if (job.onlyWhatDiffers)
            compared.push_back(value.parameter);
    appendReads(made, Task::read, compared);
    std::ranges::copy(writes(job.values), std::back_inserter(made));
    return made;
}

// Scaling and range narrow what may be set. The preset is read before and after, so that a command that was
// carried out without an answer can be told from one that never arrived.
NodeSteps NodePlan::steps(const SetPreset &job) const
{
    NodeSteps made;
    appendRefresh(made, {Parameter::scaling, Parameter::measuringRange, Parameter::preset});
    made.push_back(stepOf(Task::positionBefore, Effect::reads, object::position));
    made.push_back(sending(Task::preset, Effect::setsPosition, object::preset, job.value.value_or(0)));
    made.back().parameters = {Parameter::preset};
    appendRefresh(made, {Parameter::preset, Parameter::offset});
    made.push_back(stepOf(Task::positionAfter, Effect::reads, object::position));
    if (!m_device.capabilities.presetIsStored)
        made.push_back(store());
    return made;
}

// Mostly in force only after a reset, so there is one.
NodeSteps NodePlan::steps(const ResetToDefault & /*job*/) const
{
    NodeSteps made;
    made.push_back(sending(Task::restore, Effect::stores, object::restore, object::loadSignature));
    made.push_back(nmt(NmtCommand::resetNode));
    made.push_back(stepOf(Task::bootUp, Effect::none, {}));
    appendReads(made, Task::refresh, m_device.readableValues());
    return made;
}

NodeSteps NodePlan::steps(const ReadCams & /*job*/) const
{
    NodeSteps made;
    for (const CamField field : camFieldsOf(m_device.capabilities.cams.value_or(CamAbilities()))) {
        made.push_back(stepOf(Task::readCam, Effect::readsCams, camObject(field)));
        made.back().cam = field;
    }
    return made;
}

// Makes have them of other sizes: their answers tell.
NodeSteps NodePlan::steps(const WriteCams &job) const
{
    NodeSteps made;
    if (job.onlyWhatDiffers)
        made = steps(ReadCams());
    else if (!m_cams)
        for (const CamField field : camFieldsOf(m_device.capabilities.cams.value_or(CamAbilities())))
            made.push_back(stepOf(Task::refresh, Effect::reads, camObject(field)));
    for (const CamProgram &program : job.programs)
        std::ranges::copy(
            cams(program, job.onlyWhatDiffers && m_cams ? std::optional(m_cams->program) : std::nullopt),
            std::back_inserter(made));
    return made;
}

NodeSteps NodePlan::steps(const StoreParameters & /*job*/) const
{
    return {store()};
}

NodeSteps NodePlan::writes(const ParameterValues &values) const
{
    NodeSteps made;
    if (values.empty())
        return made;
    const bool moves = std::ranges::any_of(values, isOfPosition, &ParameterValue::parameter);
    if (moves)
        made.push_back(stepOf(Task::positionBefore, Effect::reads, object::position));
    appendWrites(made, values);
    if (std::ranges::any_of(
            values, [&](const ParameterValue &value) { return m_device.find(value.parameter)->stored; }))
        made.push_back(store());
    if (moves) {
        appendRefresh(made, {Parameter::operatingParameters, Parameter::offset});
        made.push_back(stepOf(Task::positionAfter, Effect::reads, object::position));
    }
    return made;
}

void NodePlan::appendWrites(NodeSteps &steps, const ParameterValues &values) const
{
    ByObject byObject;
    for (const ParameterValue &value : values) {
        const CanopenReach &reach = reachOf(value.parameter);
        const auto same = std::ranges::find_if(
            byObject, [&](const auto &one) { return reach.bit && one.first.object == reach.object; });
        if (same != byObject.end())
            same->second.push_back(value);
        else
            byObject.push_back({reach, {value}});
    }
    std::ranges::stable_sort(byObject, {}, [](const auto &one) { return turnOf(one.second); });
    if (std::ranges::any_of(byObject, [](const auto &one) { return isMakers(one.first.object); }))
        steps.push_back(stepOf(Task::vendor, Effect::reads, object::vendor));
    for (const auto &[reach, together] : byObject) {
        if (reach.bit)
            steps.push_back(stepOf(Task::bits, Effect::reads, reach.object));
        steps.push_back(write(together));
        if (m_device.find(together.front().parameter)->canBeRead)
            steps.push_back(readBack(steps.back()));
    }
}

NodeStep NodePlan::write(const ParameterValues &values) const
{
    const CanopenReach &reach = reachOf(values.front().parameter);
    NodeStep step = stepOf(Task::write, Effect::takes, reach.object);
    for (const ParameterValue &value : values) {
        step.values.push_back(value);
        step.parameters.push_back(value.parameter);
        if (reach.bit)
            step.line += " b" + QByteArray::number(*reachOf(value.parameter).bit);
        step.line += '=' + value.value.toString().toUtf8();
    }
    if (!reach.bit)
        step.data = values.front().value.asNumber();
    return step;
}

NodeStep NodePlan::readBack(const NodeStep &write) const
{
    NodeStep step = stepOf(Task::readBack, Effect::reads, write.object);
    step.parameters = write.parameters;
    step.values = write.values;
    step.cam = write.cam;
    step.number = write.number;
    return step;
}

NodeSteps NodePlan::cams(const CamProgram &program, const std::optional<CamProgram> &has) const
{
    NodeSteps made;
    for (const CamField field : camFieldsOf(m_device.capabilities.cams.value_or(CamAbilities()))) {
        const std::int64_t value = codewheel::valueOf(program, field);
        if (has && codewheel::valueOf(*has, field) == value)
            continue;
        made.push_back(sending(Task::writeCam, Effect::takesCams, camObject(field), value));
        made.back().cam = field;
    }
    if (!made.empty())
        made.push_back(store());
    return made;
}

NodeStep NodePlan::store()
{
    NodeStep step = sending(Task::store, Effect::stores, object::store, object::saveSignature);
    step.line = objectText(object::store) + "=save";
    return step;
}

NodeStep NodePlan::nmt(NmtCommand command)
{
    NodeStep step = stepOf(Task::nmt, Effect::none, {});
    step.command = command;
    step.line = "NMT " + QByteArray::number(static_cast<int>(command));
    return step;
}

NodeStep NodePlan::started()
{
    return stepOf(Task::started, Effect::none, {});
}

const CanopenReach &NodePlan::reachOf(Parameter parameter) const
{
    static const CanopenReach none;
    const ParameterDescription *its = m_device.find(parameter);
    const CanopenReach *reach = its != nullptr ? canopenReach(*its) : nullptr;
    return reach != nullptr ? *reach : none;
}

// An object that several of them are bits of is read once.
void NodePlan::appendReads(NodeSteps &steps, Task task, const std::vector<Parameter> &parameters) const
{
    std::map<std::pair<int, int>, std::size_t> there;
    for (const Parameter parameter : parameters) {
        const ParameterDescription *its = m_device.find(parameter);
        if (its == nullptr || !its->canBeRead)
            continue;
        const SdoObject object = reachOf(parameter).object;
        const auto [step, isNew] = there.try_emplace({object.index, object.sub}, steps.size());
        if (isNew)
            steps.push_back(stepOf(task, Effect::reads, object));
        steps[step->second].parameters.push_back(parameter);
    }
}

void NodePlan::appendRefresh(NodeSteps &steps, std::initializer_list<Parameter> parameters) const
{
    appendReads(steps, Task::refresh, parameters);
}

} // namespace codewheel::canopen
