// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/write_plan.h"

#include "catalog/device_description.h"
#include "jobs/job_check.h"
#include "jobs/protocol.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace codewheel {
namespace {

// The context of these texts.
struct WriteWords
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::WriteWords)
};

std::vector<WriteRow>::iterator rowOf(std::vector<WriteRow> &rows, Parameter parameter)
{
    return std::ranges::find(rows, parameter, [](const WriteRow &row) { return row.wanted.parameter; });
}

// A value that was not wanted exists only in the request.
void addSent(std::vector<WriteRow> &rows, const Step &step, const ParameterValues &allWanted,
             const ParameterValues &sent)
{
    for (const Parameter parameter : step.parameters) {
        const auto wanted = findValue(allWanted, parameter);
        const auto value = wanted ? wanted : findValue(sent, parameter);
        if (const auto row = rowOf(rows, parameter); row != rows.end())
            row->step = step;
        else if (value)
            rows.push_back({.wanted = {parameter, *value}, .step = step, .goesAlong = !wanted});
    }
}

bool isRearmed(const EncoderSession &encoder, const WriteWish &wish, const WriteRow &row)
{
    return row.step && row.wanted.parameter == Parameter::preset &&
           encoder.device().quirks.presetNeedsRearming && wish.initialisePreset && !wish.writeAll &&
           !holdsOtherValues(encoder) && isThereAlready(encoder, row.wanted);
}

bool isOnlyStored(const EncoderSession &encoder, const WriteWish &wish, const WriteRow &row)
{
    return row.step && !wish.writeAll && !holdsOtherValues(encoder) && isOnlyToBeStored(encoder, row.wanted);
}

std::vector<WriteRow> rowsOf(const EncoderSession &encoder, const WriteWish &wish, const WritePlan &plan)
{
    const ParameterValues allWanted = inTurn(encoder.device(), wish);
    std::vector<WriteRow> rows;
    for (const Step &step : plan.steps)
        if (writesValue(step))
            addSent(rows, step, allWanted, protocolOf(encoder.device()).valuesIn(encoder.device(), step));
    for (const ParameterValue &wanted : allWanted)
        if (rowOf(rows, wanted.parameter) == rows.end())
            rows.push_back({.wanted = wanted});
    for (WriteRow &row : rows) {
        row.known = encoder.known(row.wanted.parameter);
        if (const auto checked = checkValue(encoder.device(), row.wanted, encoder.valueOptions()); !checked)
            row.hindrance = checked.error();
        row.isThere = !row.step && !row.hindrance && !findValue(plan.job.values, row.wanted.parameter);
        row.isRearmed = isRearmed(encoder, wish, row);
        row.isOnlyStored = isOnlyStored(encoder, wish, row);
        const auto storing = std::ranges::find(plan.steps, Effect::stores, &Step::effect);
        if (row.isOnlyStored && storing != plan.steps.end())
            row.step = *storing;
    }
    return rows;
}

std::optional<ForetoldPosition> positionThen(const EncoderSession &encoder, const ParameterValues &written,
                                             const ParameterValues &known)
{
    const DeviceDescription &device = encoder.device();
    const bool isOffsetMissing =
        valueOf(written, Parameter::offset) && !valueOf(known, Parameter::offset); // counts as 0 in a scale
    if (isOffsetMissing || !encoder.showsPosition() || encoder.freshness().isOld())
        return std::nullopt;
    const auto now = scaleOf(device, [&](Parameter its) { return valueOf(known, its); });
    const auto then = scaleAfter(device, written, known);
    return now && then ? foretellPosition(*now, *encoder.latest().position, *then) : std::nullopt;
}

// That another scaling moves the position is a note of its own.
std::optional<ValueNote> shiftNote(const EncoderSession &encoder, const ParameterValues &written)
{
    const ParameterValues known = valuesOf(allKnown(encoder));
    const auto changes = [&](Parameter its) {
        const auto value = valueOf(written, its);
        return value && value != valueOf(known, its);
    };
    static constexpr std::array shifting{Parameter::zeroOffset, Parameter::offset, Parameter::direction,
                                         Parameter::coding};
    if (std::ranges::none_of(shifting, changes))
        return std::nullopt;
    const auto then = positionThen(encoder, written, known);
    if (!then)
        return ValueNote{ValueNote::Id::positionShifts, {QString(), QString()}};
    const std::int64_t now = *encoder.latest().position;
    if (then->exact && then->position == now)
        return std::nullopt;
    return ValueNote{then->exact ? ValueNote::Id::positionShifts : ValueNote::Id::positionShiftsAbout,
                     {now, then->position}};
}

// A flag that was read is 0 then.
ValueNote rearmNote(const EncoderSession &encoder)
{
    const auto flag = encoder.known(Parameter::presetFlag);
    const bool isSure = flag && flag->evidence == Evidence::read;
    return {isSure ? ValueNote::Id::presetUsedUp : ValueNote::Id::presetMayBeUsedUp, {}};
}

void addNotes(const EncoderSession &encoder, const WriteWish &wish, WritePlan &plan)
{
    const bool setsPosition = wish.initialisePreset || wish.setPositionTo;
    plan.notes = valueNotes(encoder.device(), plan.job.values, valuesOf(allKnown(encoder)),
                            setsPosition ? PositionIsSet::yes : PositionIsSet::no);
    if (const auto leftOut = leftOutNote(encoder.device(), wish))
        plan.notes.push_back(*leftOut);
    if (std::ranges::any_of(plan.rows, &WriteRow::isRearmed))
        plan.notes.push_back(rearmNote(encoder));
    if (setsPosition)
        return;
    if (const auto shift = shiftNote(encoder, plan.job.values))
        plan.notes.push_back(*shift);
}

} // namespace

std::optional<ValueNote> leftOutNote(const DeviceDescription &device, const WriteWish &wish)
{
    const auto leftOut = offsetLeftOut(device, wish);
    return leftOut ? std::optional(ValueNote{ValueNote::Id::offsetLeftOut, {argumentOf(leftOut->value)}})
                   : std::nullopt;
}

QString parameterNames(const std::vector<Parameter> &parameters)
{
    QStringList names;
    for (const Parameter parameter : parameters)
        names << parameterNameInText(parameter);
    return names.join(QStringLiteral(", "));
}

QString readsFirstText()
{
    return WriteWords::tr("The encoder is read first; what it already has is not written again.");
}

QStringList howItIsWritten(const WritePlan &plan)
{
    QStringList notes;
    if (!plan.lostAndNotWritten.empty())
        notes << WriteWords::tr(
                     "The encoder has lost its parameters (error 3), and works again only with all "
                     "of parameters 1 to 4. Without a value: %1. Want these too, or reset it to its "
                     "default values.")
                     .arg(parameterNames(plan.lostAndNotWritten));
    std::vector<Parameter> besides;
    for (const WriteRow &row : plan.rows)
        if (row.isInStepOfOthers())
            besides.push_back(row.wanted.parameter);
    if (!besides.empty())
        notes << WriteWords::tr("The encoder takes all its values at once. These go along as they are "
                                "known, otherwise as from the factory: %1.")
                     .arg(parameterNames(besides));
    std::vector<Parameter> onlyStored;
    for (const WriteRow &row : plan.rows)
        if (row.isOnlyStored)
            onlyStored.push_back(row.wanted.parameter);
    if (!onlyStored.empty())
        notes << WriteWords::tr("In force already; only stored, since that may not have been done: %1.")
                     .arg(parameterNames(onlyStored));
    if (plan.job.onlyWhatDiffers)
        notes << readsFirstText();
    if (plan.stepsMayBeLess)
        notes << WriteWords::tr("If the encoder counts steps minus 1, the word for the steps is one less.");
    return notes;
}

WritePlan planWrite(const EncoderSession &encoder, const WriteWish &wish)
{
    const DeviceDescription &device = encoder.device();
    WritePlan plan{.job = jobForWish(encoder, wish), .jobs = jobsForWish(encoder, wish)};
    plan.stepsMayBeLess = device.quirks.mayCountStepsMinusOne &&
                          !encoder.known(Parameter::multiTurnAndStepsMinusOne) &&
                          valueOf(plan.job.values, Parameter::steps);
    if (auto steps = encoder.planned(plan.jobs); steps)
        plan.steps = std::move(*steps);
    else if (plan.jobs.clear(); steps.error().id != RefusalId::nothingToDo)
        plan.refusal = steps.error();
    plan.rows = rowsOf(encoder, wish, plan);
    plan.lostAndNotWritten = lostAndNotAmong(encoder, plan.job.values);
    addNotes(encoder, wish, plan);
    return plan;
}

} // namespace codewheel
