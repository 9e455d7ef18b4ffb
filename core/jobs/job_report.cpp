// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/job_report.h"

#include "catalog/value_text.h"
#include "jobs/value_notes.h"
#include "vocabulary/hex.h"
#include "vocabulary/mode_text.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

namespace codewheel {
namespace {

// "Steps = 255, Direction = cw"
QString valuesText(const ParameterValues &values, const DeviceDescription &device)
{
    QStringList texts;
    for (const ParameterValue &value : values) {
        const ParameterDescription *description = device.find(value.parameter);
        const Choice *choice = description ? description->findChoice(value.value) : nullptr;
        const bool hasForm = description && description->form;
        const QString text = choice    ? choice->key
                             : hasForm ? valueText(*description, value.value)
                                       : plainText(value.value);
        texts += parameterName(value.parameter) + QStringLiteral(" = ") + text;
    }
    return texts.join(QStringLiteral(", "));
}

RefusalArgument positionArgument(const std::optional<std::int64_t> &position)
{
    return position ? RefusalArgument(*position) : RefusalArgument(QString());
}

Message written(const Outcome &outcome, const DeviceDescription &device, const ParameterValues &known)
{
    return {.id = scalingNote(device, outcome.written, known) ? MessageId::writtenUnscaled
                                                              : MessageId::parametersWritten,
            .arguments = {static_cast<std::int64_t>(outcome.written.size()),
                          std::int64_t{outcome.eepromWrites}, valuesText(outcome.written, device)}};
}

Message presetDone(const Outcome &outcome)
{
    return {.id = MessageId::presetDone,
            .arguments = {positionArgument(outcome.positionBefore), positionArgument(outcome.positionAfter)}};
}

Message refused(const Refusal &why)
{
    const bool isFault = why.kind == RefusalKind::device || why.kind == RefusalKind::link;
    return {.severity = isFault ? Severity::fault : Severity::attention, .refusal = why};
}

// "1, 3"
QString programs(const std::vector<CamProgram> &cams)
{
    QStringList numbers;
    for (const CamProgram &program : cams)
        numbers += QString::number(program.number);
    return numbers.join(QStringLiteral(", "));
}

// The previous values, and the evidence for them.
Message restored(const Outcome &outcome, const DeviceDescription &device)
{
    QStringList texts;
    if (!outcome.written.empty())
        texts += valuesText(outcome.written, device);
    if (!outcome.camsWritten.empty())
        texts +=
            QCoreApplication::translate("JobReport", "cam program %1").arg(programs(outcome.camsWritten));
    return {.id = outcome.restored == Evidence::read ? MessageId::restoredReadBack
                                                     : MessageId::restoredConfirmed,
            .arguments = {texts.join(QStringLiteral(", ")), std::int64_t{outcome.eepromWrites}}};
}

// What is reported of a job that succeeded.
struct Success
{
    const Outcome &outcome;
    const DeviceDescription &device;
    const ParameterValues &known;

    std::vector<Message> operator()(const ReadParameters &) const
    {
        return {
            {.id = MessageId::parametersRead, .arguments = {static_cast<std::int64_t>(outcome.read.size())}}};
    }
    std::vector<Message> operator()(const WriteParameters &job) const
    {
        std::vector<Message> messages = whatWasWritten();
        if (job.initialisePreset)
            messages.push_back(presetDone(outcome));
        return messages;
    }
    std::vector<Message> operator()(const SetPreset &) const
    {
        std::vector<Message> messages = whatWasWritten();
        messages.push_back(presetDone(outcome));
        return messages;
    }
    std::vector<Message> operator()(const SendWords &job) const
    {
        return {{.id = MessageId::wordsSent, .arguments = {static_cast<std::int64_t>(job.words.size())}}};
    }
    std::vector<Message> operator()(const EndParameterization &) const
    {
        std::vector<Message> messages = whatWasWritten();
        messages.push_back({.id = MessageId::broughtBack});
        return messages;
    }
    std::vector<Message> operator()(const SwitchMode &job) const
    {
        return {outcome.onlyZeroSinceRun
                    ? Message{.id = MessageId::modeSentToZero, .arguments = modeArguments(job)}
                    : Message{.id = MessageId::modeSwitched, .arguments = modeArguments(job)}};
    }
    std::vector<Message> operator()(const ResetToDefault &) const
    {
        return {{.id = MessageId::resetDone, .arguments = {std::int64_t{outcome.eepromWrites}}}};
    }
    std::vector<Message> operator()(const ReadCams &) const
    {
        return {
            {.id = MessageId::camsRead, .arguments = {static_cast<std::int64_t>(outcome.camsRead.size())}}};
    }
    std::vector<Message> operator()(const WriteCams &job) const
    {
        if (outcome.camsWritten.empty()) // the encoder already had everything
            return (*this)(ReadCams{.programs = {}, .afterwards = job.afterwards});
        return whatWasWritten();
    }
    std::vector<Message> whatWasWritten() const
    {
        if (outcome.restored)
            return {restored(outcome, device)};
        std::vector<Message> messages;
        if (!outcome.written.empty())
            messages.push_back(written(outcome, device, known));
        if (!outcome.camsWritten.empty())
            messages.push_back(
                {.id = MessageId::camsWritten,
                 .arguments = {programs(outcome.camsWritten), std::int64_t{outcome.eepromWrites}}});
        return messages;
    }
};

// What the encoder can be asked for, and what not: of a position only the machine can tell.
std::pair<InDoubt, InDoubt> byWhetherItCanBeRead(const InDoubt &doubt, const DeviceDescription &device)
{
    InDoubt readable;
    InDoubt others;
    for (const ParameterValue &value : doubt.values) {
        const ParameterDescription *parameter = device.find(value.parameter);
        (parameter != nullptr && parameter->canBeRead ? readable : others).values.push_back(value);
    }
    (device.capabilities.reads ? readable : others).reset = doubt.reset;
    others.position = doubt.position;
    readable.camPrograms = doubt.camPrograms;
    return {readable, others};
}

} // namespace

QString doubtText(const InDoubt &doubt, const DeviceDescription &device)
{
    QStringList texts;
    if (!doubt.values.empty())
        texts += valuesText(doubt.values, device);
    if (doubt.reset)
        texts += QCoreApplication::translate("JobReport", "factory settings");
    if (doubt.position)
        texts += QCoreApplication::translate("JobReport", "position");
    for (const unsigned program : doubt.camPrograms)
        texts += QCoreApplication::translate("JobReport", "cam program %1").arg(program);
    return texts.join(QStringLiteral(", "));
}

std::vector<Message> doubtReport(const InDoubt &doubt, const DeviceDescription &device)
{
    std::vector<Message> messages;
    const auto add = [&](MessageId id, const InDoubt &part) {
        if (const QString text = doubtText(part, device); !text.isEmpty())
            messages.push_back({.severity = Severity::attention,
                                .id = id,
                                .arguments = {text, std::int64_t{doubt.eepromWrites}}});
    };
    const auto [readable, others] = byWhetherItCanBeRead(doubt, device);
    add(MessageId::inDoubt, readable);
    add(MessageId::inDoubtForGood, others);
    QStringList words;
    for (const Word out : doubt.out)
        words << hexWord(out);
    if (!words.isEmpty())
        messages.push_back({.severity = Severity::attention,
                            .id = MessageId::outLeft,
                            .arguments = {words.join(QCoreApplication::translate("JobReport", " or "))}});
    return messages;
}

QStringList doubtSentences(const InDoubt &doubt, const DeviceDescription &device)
{
    QStringList sentences;
    for (const Message &message : doubtReport(doubt, device))
        sentences << messageText(message);
    return sentences;
}

std::vector<Message> jobReport(const Job &job, const Outcome &outcome, const DeviceDescription &device,
                               const ParameterValues &known)
{
    const Success success{outcome, device, known};
    std::vector<Message> messages = outcome.result ? std::visit(success, job) : success.whatWasWritten();
    if (!outcome.result)
        messages.push_back(refused(outcome.result.error()));
    for (Message &message : doubtReport(outcome.inDoubt, device))
        messages.push_back(std::move(message));
    if (outcome.inDoubt.eepromWrites > 0)
        messages.push_back({.severity = Severity::attention,
                            .id = MessageId::writesInDoubt,
                            .arguments = {std::int64_t{outcome.inDoubt.eepromWrites}}});
    if (outcome.onlyZeroSinceRun && !std::holds_alternative<SwitchMode>(job))
        messages.push_back({.severity = Severity::attention, .id = MessageId::onlyZeroSinceRun});
    if (outcome.leftIn == EncoderState::parameterization)
        messages.push_back({.severity = Severity::attention,
                            .id = std::holds_alternative<ResetToDefault>(job)
                                      ? MessageId::resetWaitsForRun
                                      : MessageId::leftInParameterization});
    if (outcome.leftIn == EncoderState::service)
        messages.push_back({.severity = Severity::attention, .id = MessageId::leftInService});
    return messages;
}

} // namespace codewheel
