// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/words/word_step.h"

#include "catalog/explain_word.h"
#include "kinds/interbus/words/k3_word.h"
#include "kinds/interbus/words/la66_word.h"

#include <QCoreApplication>

namespace codewheel {
namespace {

// The context of these texts.
struct StepText
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::StepTable)
};

Mode modeOf(StepKind kind)
{
    return kind == StepKind::camParameter || kind == StepKind::camReadOut ? Mode::cam : Mode::position;
}

} // namespace

Effect effectOf(StepKind kind, Word out)
{
    switch (kind) {
    case StepKind::parameter:
        return Effect::takes;
    case StepKind::serviceBit:
        return la66::isWrite(out) ? Effect::takes : Effect::reads;
    case StepKind::run:
        return Effect::activates;
    case StepKind::initialisePreset:
    case StepKind::manufacturerPreset:
        return Effect::setsPosition;
    case StepKind::readOut:
    case StepKind::endReadOut:
        return Effect::reads;
    case StepKind::camReadOut:
        return Effect::readsCams;
    case StepKind::camParameter:
        return Effect::takesCams;
    case StepKind::switchMode:
        return Effect::switchesMode;
    case StepKind::word:
        return k3::isParameterWord(out) ? Effect::takesByHand : Effect::byHand;
    case StepKind::toNormal:
    case StepKind::service:
        break;
    }
    return Effect::none;
}

QString wordStepText(const DeviceDescription &device, const Step &step)
{
    const auto kind = step.kind.as<StepKind>();
    switch (kind) {
    case StepKind::toNormal:
        return step.out == 0 ? StepText::tr("Back to normal running")
                             : StepText::tr("Take the service bit back");
    case StepKind::run:
        return StepText::tr("Run: the values become valid");
    case StepKind::initialisePreset:
        return StepText::tr("Set the position to the preset");
    case StepKind::readOut:
        if (step.parameter() == Parameter::multiTurnAndStepsMinusOne)
            return StepText::tr("Read whether the encoder counts steps minus 1");
        return step.parameter() ? StepText::tr("Read %1").arg(parameterNameInText(*step.parameter()))
                                : StepText::tr("Read out");
    case StepKind::endReadOut:
        return StepText::tr("End the read-out");
    case StepKind::manufacturerPreset:
        return StepText::tr("Set the position to the preset, for one bus cycle");
    case StepKind::service:
    case StepKind::serviceBit:
    case StepKind::switchMode:
    case StepKind::camParameter:
    case StepKind::camReadOut:
    case StepKind::parameter:
    case StepKind::word:
        break;
    }
    return explanationText(
        device,
        explainWord(
            device, step.out,
            {.direction = WordDirection::out, .mode = modeOf(kind), .coding = {}, .counterpart = {}}));
}

} // namespace codewheel
