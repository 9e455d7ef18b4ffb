// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/wizard/shaft_consequences.h"

#include "encoder/refusal_text.h"
#include "encoder/sentence.h"
#include "widgets/look/grid.h"
#include "widgets/look/inline_message.h"
#include "widgets/models/device_traits.h"
#include "widgets/wizard/gear_panel.h"
#include "widgets/wizard/scale_preview.h"
#include "widgets/wizard/wanted_scale.h"
#include "words/k3_word.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QVBoxLayout>

namespace codewheel {

ShaftConsequences::ShaftConsequences(Setup &setup, QWidget *parent)
    : Consequences(setup, parent)
    , m_scaleText(new QLabel(this))
    , m_warning(new InlineMessage(this))
    , m_gear(new GearPanel(this))
    , m_preview(new ScalePreview(this))
{
    m_scaleText->setObjectName(QStringLiteral("scaleText"));
    m_scaleText->setWordWrap(true);
    m_warning->setObjectName(QStringLiteral("scaleWarning"));
    auto *aids = new QHBoxLayout;
    aids->setSpacing(grid::margin);
    aids->addWidget(m_gear, 1, Qt::AlignTop);
    aids->addWidget(m_preview, 0, Qt::AlignTop);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(grid::margin);
    layout->addWidget(m_scaleText);
    layout->addWidget(m_warning);
    layout->addLayout(aids);
    connect(m_gear, &GearPanel::chosen, this, [this](qint64 steps, qint64 revolutions) {
        ParameterValues values{{Parameter::steps, steps}};
        if (!isOnLine(m_setup.encoder->device()))
            values.push_back({Parameter::revolutions, revolutions});
        Q_EMIT chosen(values);
    });
}

void ShaftConsequences::showLimits()
{
    const DeviceDescription &device = m_setup.encoder->device();
    GearLimits limits{.physicalStepsPerTurn = device.physicalStepsPerTurn};
    if (isOnLine(device)) { // it takes the steps of one turn
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
    m_scaleText->setText(
        then ? scaleText(*then)
             : tr("Resolution and range can be told once steps, revolutions and direction are "
                  "known or wanted."));
    const QString warning = then ? warningFor(*then) : QString();
    if (warning.isEmpty())
        m_warning->withdraw();
    else if (warning != m_warning->sentence())
        m_warning->showMessage(Role::attention, warning);
    const auto start = positionAfterHandshake(m_setup);
    m_preview->setScale(
        then, start ? std::optional(start->position) : std::nullopt,
        tr("What it will read here cannot be told: the zero offset or the scale is not known."));
}

QString ShaftConsequences::scaleText(const PositionScale &scale) const
{
    return tr("Resolution %1 steps per turn, total range %2 steps over %3 turns.")
        .arg(QLocale().toString(scale.resolution(), 'f', scale.steps % scale.revolutions == 0 ? 0 : 3),
             numberText(scale.total()), numberText(scale.turns));
}

QString ShaftConsequences::warningFor(const PositionScale &scale) const
{
    const std::int64_t most = scale.physicalStepsPerTurn * scale.revolutions;
    if (most > 0 && scale.steps > most)
        return refusalText({RefusalKind::badInput,
                            RefusalId::tooManyStepsPerTurn,
                            {scale.steps, scale.revolutions, scale.physicalStepsPerTurn}});
    if (scale.total() > k3::largestTotalRange)
        return refusalText(
            {RefusalKind::badInput, RefusalId::totalRangeTooLarge, {scale.total(), k3::largestTotalRange}});
    for (const Parameter parameter : {Parameter::preset, Parameter::offset})
        if (const auto value = m_setup.valueAfter(parameter);
            value && *value >= scale.total() && !isOnLine(m_setup.encoder->device()))
            return refusalText({RefusalKind::badInput,
                                RefusalId::valueAboveTotalRange,
                                {parameter, *value, scale.total() - 1}});
    switch (wrapJump(scale)) {
    case WrapJump::none:
        return {};
    case WrapJump::rangeDoesNotDivideTurns:
        return tr("The position will jump: the measuring range of %1 turns does not divide the %2 turns of "
                  "the "
                  "encoder. Where those are used up, it goes from %3 to 0.")
            .arg(numberText(scale.turns), numberText(scale.physicalTurns),
                 numberText(lastPositionBeforeWrap(scale)));
    case WrapJump::totalIsNotWhole:
        return tr("The position will jump a little: %1 steps in %2 revolutions give no whole number of steps "
                  "over "
                  "%3 turns. A fraction of a step is lost each time they are used up.")
            .arg(numberText(scale.steps), numberText(scale.revolutions), numberText(scale.turns));
    }
    return {};
}

} // namespace codewheel
