// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/cams/cam_outcome_text.h"

#include <QCoreApplication>
#include <QStringList>

namespace codewheel::cam_outcome {
namespace {

// The context of these texts.
struct CamOutcome
{
    Q_DECLARE_TR_FUNCTIONS(CamOutcome)
};

QString eepromText(const Outcome &outcome)
{
    return outcome.eepromWrites == 0
               ? QString()
               : QLatin1Char(' ') + CamOutcome::tr("EEPROM writes: %1.").arg(outcome.eepromWrites);
}

} // namespace

QString programList(const std::vector<CamProgram> &programs)
{
    QStringList numbers;
    for (const CamProgram &program : programs)
        numbers << QString::number(program.number);
    return numbers.join(QStringLiteral(", "));
}

QString difference(const CamProgram &wanted, const CamProgram &encoder)
{
    QStringList parts;
    for (std::size_t cam = 0; cam < CamProgram::cams; ++cam)
        if (wanted.cam.at(cam) != encoder.cam.at(cam))
            parts << CamOutcome::tr("cam %1").arg(cam);
    if (wanted.shift != encoder.shift)
        parts << CamOutcome::tr("the shift (the encoder has %1)").arg(encoder.shift);
    if (parts.isEmpty())
        return {};
    return CamOutcome::tr("Program %1 differs in: %2.")
        .arg(wanted.number)
        .arg(parts.join(QStringLiteral(", ")));
}

QString readText(const Outcome &outcome)
{
    const QString pattern = outcome.camsRead.size() == 1 ? CamOutcome::tr("Program %1 was read.")
                                                         : CamOutcome::tr("Programs %1 were read.");
    return pattern.arg(programList(outcome.camsRead)) + eepromText(outcome);
}

QString writtenText(const Outcome &outcome)
{
    if (outcome.camsWritten.empty())
        return CamOutcome::tr("The encoder has all of it already. Nothing was written.") +
               eepromText(outcome);
    const QString pattern = outcome.camsWritten.size() == 1
                                ? CamOutcome::tr("Program %1 was written and read back.")
                                : CamOutcome::tr("Programs %1 were written and read back.");
    return pattern.arg(programList(outcome.camsWritten)) + eepromText(outcome);
}

} // namespace codewheel::cam_outcome
