// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/line/write_question.h"

#include "kinds/esc/line/row_text.h"
#include "vocabulary/sentence.h"

#include <QCoreApplication>

namespace codewheel {
namespace {

struct WriteConsequence
{
    Q_DECLARE_TR_FUNCTIONS(WriteConsequence)
};

QString consequence(esc::Command command)
{
    using enum esc::Command;
    switch (command) {
    case writePreset:
        return WriteConsequence::tr("The position becomes this value at once.");
    case writeDirection:
        return WriteConsequence::tr("The position may count the other way and jump.");
    case writeStepsPerTurn:
    case writeRevolutions:
    case writeMeasuringRange:
    case writeScalingFactor:
    case writeScaling:
        return WriteConsequence::tr("The position may jump.");
    case writeLowerLimit:
    case writeUpperLimit:
        return WriteConsequence::tr("The limit switch may change its state.");
    case writeAddress:
        return WriteConsequence::tr("The encoder answers at the new address from then on.");
    case writeBaudRate:
        return WriteConsequence::tr("The encoder answers at the new baud rate from then on.");
    default:
        return {};
    }
}

} // namespace

QString writeQuestion(const esc::Request &request, const esc::ExplainOptions &options)
{
    QStringList parts{
        sentence(WriteConsequence::tr("%1 (%2)."),
                 {esc::requestText(request, options), QString::fromLatin1(request.text())}),
        consequence(request.command), WriteConsequence::tr("It costs one EEPROM write."),
        sentence(WriteConsequence::tr("These bytes are sent once: %1."), {byteText(request.bytes())})};
    if (request.to.isMaster())
        parts << WriteConsequence::tr("The address 00 is that of every encoder: all on the line take it.");
    parts.removeAll(QString());
    return parts.join(u' ');
}

} // namespace codewheel
