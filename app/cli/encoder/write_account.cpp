// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/encoder/write_account.h"

#include "catalog/device_description.h"
#include "cli/call/text_table.h"
#include "cli/call/texts.h"
#include "cli/encoder/parameter_text.h"
#include "cli/encoder/position_text.h"
#include "jobs/values_to_write.h"
#include "vocabulary/sentence.h"

#include <algorithm>

namespace codewheel {

WriteAccount::WriteAccount(const EncoderSession &encoder, const ParameterValues &wanted,
                           const FinishedJob &job)
    : m_encoder(encoder)
    , m_wanted(wanted)
    , m_job(job)
{}

QString WriteAccount::fateOf(const ParameterValue &value) const
{
    if (findValue(outcome().written, value.parameter)) {
        const auto known = m_encoder.known(value.parameter);
        return known && known->evidence == Evidence::read
                   ? CommandLine::tr("written, and read back")
                   : CommandLine::tr("written, confirmed by the handshake");
    }
    if (findValue(outcome().stored, value.parameter))
        return CommandLine::tr("in force before, and stored now");
    if (findValue(outcome().alreadyThere, value.parameter))
        return CommandLine::tr("already there");
    if (findValue(outcome().inDoubt.values, value.parameter))
        return CommandLine::tr("sent: it is not known whether the encoder has it");
    if (findValue(outcome().confirmed, value.parameter))
        return CommandLine::tr("confirmed; takes effect only with run");
    if (std::ranges::count(m_job.sent, value.parameter) == 0)
        return CommandLine::tr("not sent");
    return findValue(outcome().notActive, value.parameter) ? CommandLine::tr("did not become active")
                                                           : fateOfUnconfirmed();
}

QString WriteAccount::fateOfUnconfirmed() const
{
    const auto error = m_encoder.latest().errorNumber;
    if (outcome().leftIn == EncoderState::error && error.value_or(0) != 0)
        return sentence(CommandLine::tr("sent, and refused by the encoder (error %1)"),
                        {QString::number(*error)});
    const bool isUnanswered =
        !outcome().result && (outcome().result.error().id == RefusalId::noAnswer ||
                              outcome().result.error().id == RefusalId::noAnswerAtGateway);
    return isUnanswered ? CommandLine::tr("sent, and not answered")
                        : CommandLine::tr("did not become active");
}

QString WriteAccount::toText() const
{
    TextTable table;
    const auto add = [&](const ParameterValue &value, const QString &fate) {
        const ParameterDescription &parameter = *m_encoder.device().find(value.parameter);
        table.add({parameterKey(value.parameter),
                   QStringLiteral("= %1").arg(typedValue(parameter, value.value)), fate});
    };
    for (const ParameterValue &value : m_wanted)
        add(value, fateOf(value));
    for (const ParameterValue &value : outcome().setAlong)
        add(value, CommandLine::tr("set by the encoder itself, with the steps"));
    return table.toString();
}

QString WriteAccount::whereItWasLeft() const
{
    return codewheel::whereItWasLeft(outcome(), m_encoder.latest());
}

} // namespace codewheel
