// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/kinds/canopen/object_writing.h"

#include "cli/call/json.h"
#include "cli/call/texts.h"
#include "cli/encoder/consent.h"
#include "cli/encoder/eeprom_consent.h"
#include "kinds/canopen/protocol/canopen_reach.h"
#include "kinds/canopen/protocol/canopen_refusals.h"
#include "kinds/canopen/protocol/encoder_objects.h"
#include "vocabulary/sentence.h"

#include <algorithm>

namespace codewheel {
namespace {

using Transfer = canopen::SdoOutcome::Kind;

// Storing and restoring write to the EEPROM; of other objects nobody knows.
bool isCounted(canopen::SdoObject object)
{
    return object.index == 0x1010 || object.index == 0x1011;
}

// The preset, and those of several sensors.
bool setsPosition(canopen::SdoObject object)
{
    constexpr std::uint16_t presetsOfSensors = 0x6010;
    return object.index == canopen::object::preset.index || object.index == presetsOfSensors;
}

using WhenStopped = CanopenAccess::WhenStopped;

Checked<canopen::SdoOutcome> readObject(const NodeMeant &where, canopen::SdoObject object,
                                        WhenStopped stopped = WhenStopped::ends)
{
    return where.bus->transfer({.node = where.node(), .object = object}, stopped);
}

// Whether the user wants it, after what it has now was shown.
Checked<void> askToWriteObject(const Call &call, const NodeMeant &where, const ObjectArgument &what,
                               const std::vector<std::uint8_t> &octets,
                               const std::optional<canopen::SdoOutcome> &before)
{
    QString shown = sentence(
        CommandLine::tr("Node %1: %2 := %3"),
        {CanopenAddress{where.node()}.shown(), objectNameText(what), objectValueText(what, octets, true)});
    if (before && before->kind == Transfer::read)
        shown += u' ' + sentence(CommandLine::tr("(now %1)"),
                                 {objectValueText(what, before->value, before->isSizeTold)});
    if (isCounted(what.object))
        shown += u' ' + CommandLine::tr("It counts as a write to the EEPROM.");
    if (setsPosition(what.object))
        shown += u' ' + CommandLine::tr("It sets the position at once.");
    if (isMakers(what.object))
        shown += u' ' + CommandLine::tr("It is an object of the maker: it may set the position, change "
                                        "number or rate, or be stored at once. Look into the manual.");
    if (!call.arguments.has("--json"))
        call.terminal.print(shown + u'\n');
    return consent(call, CommandLine::tr("Write it?"),
                   CommandLine::tr("Nothing was written: there is nobody to ask. Add --yes."));
}

Checked<void> allowToStore(const Call &call, const NodeMeant &where)
{
    return where.bus->encoder(call, where.place.node, true).and_then([&](const EncoderSession *encoder) {
        return eepromConsent(call, *encoder, 1, AsksAnyway::yes);
    });
}

// What became of it, by what is read back. A command to store or restore gives another value when it is read.
void tellWritten(const NodeMeant &where, const ObjectArgument &what, const std::vector<std::uint8_t> &octets,
                 const canopen::SdoOutcome &before, const canopen::SdoOutcome &outcome, Answer &answer)
{
    const bool mayBeWritten = outcome.kind == Transfer::written || outcome.kind == Transfer::noAnswer;
    const bool isReadBack = mayBeWritten && !isCounted(what.object);
    const auto after =
        isReadBack ? readObject(where, what.object, WhenStopped::goesOn) : Checked<canopen::SdoOutcome>();
    const bool isKnown = isReadBack && after && after->kind == Transfer::read;
    const bool wasThere = before.kind == Transfer::read && std::ranges::equal(before.value, octets);
    const bool tells = outcome.kind == Transfer::written || !wasThere; // otherwise it is the value of before
    const bool isThere = isKnown && tells && std::ranges::equal(after->value, octets);
    const auto told = [&](const QString &fate, const QString &text) {
        answer.json.insert(QStringLiteral("fate"), fate);
        answer.text += text + u'\n';
    };
    if (isKnown)
        answer.json.insert(QStringLiteral("after"),
                           objectValueJson(what, after->value, after->isSizeTold)[u"value"]);
    if (isThere)
        return told(QStringLiteral("readBack"), CommandLine::tr("Written, and read back."));
    if (outcome.kind == Transfer::written && !isKnown)
        return told(QStringLiteral("accepted"), CommandLine::tr("Accepted, not read back."));
    const bool isAsBefore = isKnown && before.kind == Transfer::read && before.value == after->value;
    if (outcome.kind == Transfer::written || (isKnown && !isAsBefore)) {
        answer.json.insert(QStringLiteral("fate"), QStringLiteral("other"));
        answer.complaint =
            notDone("otherReadBack", sentence(CommandLine::tr("Another value is read back: %1."),
                                              {objectValueText(what, after->value, after->isSizeTold)}));
        return;
    }
    const QString object = what.object.text();
    answer.json.insert(QStringLiteral("fate"), outcome.kind == Transfer::notSent   ? QStringLiteral("notSent")
                                               : outcome.kind == Transfer::aborted ? QStringLiteral("refused")
                                               : isKnown && tells                  ? QStringLiteral("notDone")
                                                                  : QStringLiteral("unknown"));
    if (outcome.kind != Transfer::noAnswer)
        answer.complaint = aboutObjectOutcome(where, what, outcome);
    else if (isCounted(what.object))
        answer.complaint = where.bus->complaint(
            {RefusalKind::device, CanopenRefusalId::storingUnknown, {std::int64_t{where.node()}}});
    else
        answer.complaint = where.bus->complaint(
            {RefusalKind::device,
             isKnown && tells ? CanopenRefusalId::sdoWriteNotDone : CanopenRefusalId::sdoWriteUnknown,
             {object}});
}

// While it is asked what is to become of it, Ctrl+C ends the program as ever.
Checked<canopen::SdoOutcome> readForWriting(const NodeMeant &where, canopen::SdoObject object)
{
    const CanopenAccess::ByHand byHand(*where.bus);
    return readObject(where, object);
}

} // namespace

Complaint aboutObjectOutcome(const NodeMeant &where, const ObjectArgument &what,
                             const canopen::SdoOutcome &outcome)
{
    const QString object = what.object.text();
    if (outcome.kind == Transfer::aborted)
        return where.bus->complaint(
            {RefusalKind::device, CanopenRefusalId::sdoAborted, {object, Word{outcome.abortCode}}});
    return where.bus->complaint(
        {RefusalKind::link,
         outcome.kind == Transfer::notSent ? CanopenRefusalId::sdoNotSent : CanopenRefusalId::sdoNoAnswer,
         {object, std::int64_t{where.node()}}});
}

QString objectNameText(const ObjectArgument &what)
{
    return what.parameter != nullptr ? what.object.text() + u' ' + parameterKey(what.parameter->parameter)
                                     : what.object.text();
}

Checked<Answer> writeObject(const Call &call, const NodeMeant &where, const ObjectArgument &what)
{
    if (!what.value)
        return badInput("valueMissing", CommandLine::tr("Give the value behind the object, as %1=1000."),
                        {what.object.text()});
    if (const auto opened = where.bus->openToSend(call); !opened)
        return tl::unexpected(opened.error());
    const auto before = readForWriting(where, what.object);
    if (!before)
        return tl::unexpected(before.error());
    if (before->kind == Transfer::noAnswer || before->kind == Transfer::notSent)
        return tl::unexpected(aboutObjectOutcome(where, what, *before));
    const bool isSized = before->kind == Transfer::read && before->isSizeTold;
    const auto octets = octetsFor(what, isSized ? before->value.size() : 0);
    if (!octets)
        return tl::unexpected(octets.error());
    if (const auto agreed = askToWriteObject(call, where, what, *octets, *before); !agreed)
        return tl::unexpected(agreed.error());
    if (const auto may = where.bus->listenAgain(); !may)
        return tl::unexpected(may.error());
    if (isCounted(what.object))
        if (const auto may = allowToStore(call, where); !may)
            return tl::unexpected(may.error());
    const CanopenAccess::ByHand byHand(*where.bus);
    constexpr Instant longestStoring = std::chrono::seconds(5);
    canopen::SdoRequest request{.node = where.node(), .object = what.object, .value = *octets};
    if (isCounted(what.object))
        request.timeOut = longestStoring;
    const auto outcome = where.bus->transfer(request);
    if (!outcome)
        return tl::unexpected(outcome.error());
    Answer answer{.json = objectJson(what)};
    merge(answer.json, objectValueJson(what, *octets, true));
    answer.json.insert(QStringLiteral("before"),
                       before->kind == Transfer::read
                           ? objectValueJson(what, before->value, before->isSizeTold)[u"value"]
                           : QJsonValue());
    tellWritten(where, what, *octets, *before, *outcome, answer);
    return answer;
}

} // namespace codewheel
