// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/wizard/shaft_consequences.h"

#include "catalog/device_description.h"
#include "catalog/protocol_rules.h"
#include "jobs/write_plan.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"
#include "widgets/look/folding_row.h"
#include "widgets/wizard/gear_panel.h"
#include "widgets/wizard/scale_preview.h"
#include "widgets/wizard/wanted_scale.h"

#include <QLocale>

namespace codewheel {
namespace {

// The others are told of the scale.
bool isWarning(ValueNote::Id id)
{
    using Id = ValueNote::Id;
    return id == Id::revolutionsSetAlong || id == Id::offsetLeftOut || id == Id::positionShifts ||
           id == Id::positionShiftsAbout || id == Id::scalingOff || id == Id::scalingUnknown;
}

} // namespace

ShaftConsequences::ShaftConsequences(Setup &setup, QWidget *parent)
    : Consequences(setup, parent)
    , m_gear(new GearPanel(this))
    , m_preview(new ScalePreview(this))
{
    layOut({new FoldingRow(m_gear, m_preview, this), 1});
    connect(m_gear, &GearPanel::chosen, this, [this](qint64 steps, qint64 revolutions) {
        ParameterValues values{{Parameter::steps, steps}};
        if (m_setup.encoder->device().hasWords())
            values.push_back({Parameter::revolutions, revolutions});
        Q_EMIT chosen(values);
    });
}

void ShaftConsequences::showLimits()
{
    const DeviceDescription &device = m_setup.encoder->device();
    GearLimits limits{.physicalStepsPerTurn = device.physicalStepsPerTurn,
                      .totalRange = protocolRules(device.profile).largestTotalRange(device)};
    if (!device.hasWords()) { // its steps are per turn
        limits.maxRevolutions = 1;
        limits.turns = device.physicalTurns;
        m_gear->setLimits(limits);
        return;
    }
    if (device.physicalTurns != 0)
        limits.turns = m_setup.valueAfter(Parameter::measuringRange).value_or(device.physicalTurns);
    m_gear->setLimits(limits);
}

void ShaftConsequences::refresh()
{
    showLimits();
    const auto then = scaleAfter(m_setup);
    QString scale =
        then
            ? scaleText(*then)
            : tr("Resolution and range are shown once steps, revolutions and direction are known or wanted.");
    for (const ValueNote &note : notes())
        if (note.id == ValueNote::Id::presetNeeded)
            scale += u' ' + noteText(note);
    tell(scale, warnings(then).join(u' '));
    const auto start = positionAfterHandshake(m_setup);
    m_preview->setScale(
        then, start ? std::optional(start->position) : std::nullopt,
        tr("What it will read here is not known, since the zero offset or the scale is not."));
}

QString ShaftConsequences::scaleText(const PositionScale &scale) const
{
    return tr("Resolution %1 steps per turn, total range %2 steps over %3 turns.")
        .arg(QLocale().toString(scale.resolution(), 'f', scale.steps % scale.revolutions == 0 ? 0 : 3),
             numberText(scale.total()), numberText(scale.turns));
}

// What is wrong with the scale, or makes the position jump; and what is set along with it.
QStringList ShaftConsequences::warnings(const std::optional<PositionScale> &scale) const
{
    QStringList warnings;
    if (const QString about = scale ? warningFor(*scale) : QString(); !about.isEmpty())
        warnings << about;
    for (const ValueNote &note : notes())
        if (isWarning(note.id))
            warnings << noteText(note);
    return warnings;
}

std::vector<ValueNote> ShaftConsequences::notes() const
{
    return planWrite(*m_setup.encoder, m_setup.wish).notes;
}

QString ShaftConsequences::warningFor(const PositionScale &scale) const
{
    const std::int64_t most = scale.physicalStepsPerTurn * scale.revolutions;
    if (most > 0 && scale.steps > most)
        return refusalText({RefusalKind::badInput,
                            RefusalId::tooManyStepsPerTurn,
                            {scale.steps, scale.revolutions, scale.physicalStepsPerTurn}});
    const DeviceDescription &device = m_setup.encoder->device();
    const std::int64_t largest = protocolRules(device.profile).largestTotalRange(device);
    if (scale.total() > largest)
        return refusalText({RefusalKind::badInput, RefusalId::totalRangeTooLarge, {scale.total(), largest}});
    for (const Parameter parameter : {Parameter::preset, Parameter::offset})
        if (const auto value = m_setup.valueAfter(parameter);
            value && *value >= scale.total() && m_setup.encoder->device().hasWords())
            return refusalText({RefusalKind::badInput,
                                RefusalId::valueAboveTotalRange,
                                {parameter, *value, scale.total() - 1}});
    const auto jump = jumpNote(m_setup.encoder->device(), scale);
    return jump ? noteText(*jump) : QString();
}

} // namespace codewheel
