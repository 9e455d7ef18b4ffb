// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/job_report.h"

#include "catalog/value_text.h"
#include "jobs/value_notes.h"
#include "vocabulary/hex.h"
#include "vocabulary/message_items.h"
#include "vocabulary/mode_text.h"
#include "vocabulary/refusal_text.h"

#include <QStringList>

namespace codewheel {
namespace {

// As messages store it: the key of a choice, the text of what has a form of its own, otherwise what it is.
RefusalArgument storedValue(const ParameterValue &value, const DeviceDescription &device)
{
    const ParameterDescription *description = device.find(value.parameter);
    if (const Choice *choice = description ? description->findChoice(value.value) : nullptr)
        return choice->key;
    const bool hasForm = description && description->form;
    return hasForm ? RefusalArgument(valueText(*description, value.value)) : argumentOf(value.value);
}

void addValues(MessageItems &items, const ParameterValues &values, const DeviceDescription &device)
{
    for (const ParameterValue &value : values)
        addItem(items, value.parameter, storedValue(value, device));
}

// How many there are, the EEPROM writes, and what it is.
Message listing(MessageCode id, const MessageItems &items, int eepromWrites)
{
    Message message{.id = id, .arguments = {countOf(items), std::int64_t{eepromWrites}}};
    message.arguments.insert(message.arguments.end(), items.begin(), items.end());
    return message;
}

RefusalArgument positionArgument(const std::optional<std::int64_t> &position)
{
    return position ? RefusalArgument(*position) : RefusalArgument(QString());
}

Message written(const Outcome &outcome, const DeviceDescription &device, const ParameterValues &known)
{
    MessageItems items;
    addValues(items, outcome.written, device);
    return listing(scalingNote(device, outcome.written, known) ? MessageId::writtenUnscaled
                                                               : MessageId::parametersWritten,
                   items, outcome.eepromWrites);
}

Message stored(const Outcome &outcome, const DeviceDescription &device)
{
    MessageItems items;
    addValues(items, outcome.stored, device);
    return listing(MessageId::parametersStored, items, outcome.eepromWrites);
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
    MessageItems items;
    addValues(items, outcome.written, device);
    for (const CamProgram &program : outcome.camsWritten)
        addItem(items, MessageItem::camProgram, {std::int64_t{program.number}});
    return listing(outcome.restored == Evidence::read ? MessageId::restoredReadBack
                                                      : MessageId::restoredConfirmed,
                   items, outcome.eepromWrites);
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
    std::vector<Message> operator()(const StoreParameters &) const { return {stored(outcome, device)}; }
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
        else if (!outcome.stored.empty()) // otherwise the same write has stored it
            messages.push_back(stored(outcome, device));
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

MessageItems itemsInDoubt(const InDoubt &doubt, const DeviceDescription &device)
{
    MessageItems items;
    addValues(items, doubt.values, device);
    if (doubt.reset)
        addItem(items, MessageItem::factorySettings);
    if (doubt.position)
        addItem(items, MessageItem::position);
    for (const unsigned program : doubt.camPrograms)
        addItem(items, MessageItem::camProgram, {std::int64_t{program}});
    return items;
}

std::optional<MessageCode> leftInParameterization(const Outcome &outcome)
{
    const bool isSaid = !outcome.result && outcome.result.error().id == RefusalId::inParameterization;
    if (outcome.leftIn != EncoderState::parameterization || isSaid)
        return std::nullopt;
    if (outcome.resetWaits)
        return MessageId::resetWaitsForRun;
    return outcome.foundInParameterization ? MessageId::stillInParameterization
                                           : MessageId::leftInParameterization;
}

} // namespace

Message leftModeMessage(const LeftMode &left)
{
    if (left.mode == Mode::position)
        return {.id = MessageId::modeSwitched, .arguments = modeArguments(SwitchMode{Mode::position})};
    if (!left.mode)
        return {.severity = Severity::attention, .id = MessageId::leftInUnknownMode};
    return {.severity = Severity::attention,
            .id = MessageId::leftInMode,
            .arguments = modeArguments(*left.mode, left.camProgram)};
}

std::optional<Message> leftModeReport(const Outcome &outcome)
{
    const bool isSaid = !outcome.result && outcome.result.error().id == RefusalId::takenAsCamWord;
    return outcome.leftInMode && !isSaid ? std::optional(leftModeMessage(*outcome.leftInMode)) : std::nullopt;
}

QString doubtText(const InDoubt &doubt, const DeviceDescription &device)
{
    return itemsText(itemsInDoubt(doubt, device));
}

std::vector<Message> doubtReport(const InDoubt &doubt, const DeviceDescription &device)
{
    std::vector<Message> messages;
    const auto add = [&](MessageCode id, const InDoubt &part) {
        const MessageItems items = itemsInDoubt(part, device);
        if (items.empty())
            return;
        messages.push_back(listing(id, items, doubt.eepromWrites));
        messages.back().severity = Severity::attention;
    };
    const auto [readable, others] = byWhetherItCanBeRead(doubt, device);
    add(MessageId::inDoubt, readable);
    add(MessageId::inDoubtForGood, others);
    if (doubt.out.empty())
        return messages;
    messages.push_back({.severity = Severity::attention, .id = MessageId::outLeft});
    for (const Word out : doubt.out)
        messages.back().arguments.emplace_back(hexWord(out));
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
    if (const auto left = leftInParameterization(outcome))
        messages.push_back({.severity = Severity::attention, .id = *left});
    if (outcome.leftIn == EncoderState::service)
        messages.push_back({.severity = Severity::attention, .id = MessageId::leftInService});
    if (auto left = leftModeReport(outcome))
        messages.push_back(*std::move(left));
    return messages;
}

} // namespace codewheel
