// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/job/step_text.h"

#include "catalog/explain_word.h"
#include "jobs/protocol.h"

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

QString stepText(const DeviceDescription &device, const Step &step)
{
    switch (step.kind) {
    case StepKind::toNormal:
        return step.out == 0 ? StepText::tr("Back to normal running")
                             : StepText::tr("Take the service bit back");
    case StepKind::run:
        return StepText::tr("Run: the values become valid");
    case StepKind::initialisePreset:
        return StepText::tr("Set the position to the preset");
    case StepKind::readOut:
        if (step.parameter == Parameter::multiTurnAndStepsMinusOne)
            return StepText::tr("Read whether the encoder counts steps minus 1");
        return step.parameter ? StepText::tr("Read %1").arg(parameterNameInText(*step.parameter))
                              : StepText::tr("Read out");
    case StepKind::endReadOut:
        return StepText::tr("End the read-out");
    case StepKind::manufacturerPreset:
        return StepText::tr("Set the position to the preset, for one bus cycle");
    case StepKind::request:
        return protocolOf(device).requestText(step.line);
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
            {.direction = WordDirection::out, .mode = modeOf(step.kind), .coding = {}, .counterpart = {}}));
}

} // namespace codewheel
