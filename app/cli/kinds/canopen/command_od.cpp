// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/catalog.h"
#include "cli/bus/places.h"
#include "cli/call/json.h"
#include "cli/call/texts.h"
#include "cli/encoder/consent.h"
#include "cli/encoder/eeprom_consent.h"
#include "cli/kinds/canopen/canopen_link_kind.h"
#include "cli/kinds/canopen/device_on_node.h"
#include "cli/kinds/canopen/object_argument.h"
#include "kinds/canopen/protocol/canopen_reach.h"
#include "kinds/canopen/protocol/canopen_refusals.h"
#include "kinds/canopen/protocol/encoder_objects.h"
#include "vocabulary/sentence.h"

#include <algorithm>
#include <array>

namespace codewheel {
namespace {

using Kind = canopen::SdoOutcome::Kind;

constexpr const char *odExamples[] = {"od can:5 read 6004 --link canopen:training",
                                      "od can:5 read 1018:4 --json", "od can:5 write 6001=4096 --yes",
                                      "od can:5 write 1010:1=save"};

constexpr std::array odOptions{
    Option{"--type", "TYPE",
           QT_TRANSLATE_NOOP("codewheel::CommandLine",
                             "take the object for this: u8, u16, u32, i8, i16, i32 or text")},
    deviceOption,
    beyondLimitOption,
    ledgerOption,
    Option{"--yes", nullptr, QT_TRANSLATE_NOOP("codewheel::CommandLine", "write without asking")},
};

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

Complaint aboutOutcome(const NodeMeant &where, const ObjectArgument &what, const canopen::SdoOutcome &outcome)
{
    const QString object = what.object.text();
    if (outcome.kind == Kind::aborted)
        return where.bus->complaint(
            {RefusalKind::device, CanopenRefusalId::sdoAborted, {object, Word{outcome.abortCode}}});
    return where.bus->complaint(
        {RefusalKind::link,
         outcome.kind == Kind::notSent ? CanopenRefusalId::sdoNotSent : CanopenRefusalId::sdoNoAnswer,
         {object, std::int64_t{where.node()}}});
}

QString nameOf(const ObjectArgument &what)
{
    return what.parameter != nullptr ? what.object.text() + u' ' + parameterKey(what.parameter->parameter)
                                     : what.object.text();
}

using WhenStopped = CanopenAccess::WhenStopped;

Checked<canopen::SdoOutcome> readObject(const NodeMeant &where, canopen::SdoObject object,
                                        WhenStopped stopped = WhenStopped::ends)
{
    return where.bus->transfer({.node = where.node(), .object = object}, stopped);
}

Checked<Answer> runOdRead(const Call &call, const NodeMeant &where, const ObjectArgument &what)
{
    if (what.value)
        return badInput(QStringLiteral("valueNotRead"),
                        CommandLine::tr("An object that is read gets no value. To write it: codewheel-cli od "
                                        "PLACE write %1=VALUE."),
                        {what.object.text()});
    if (const auto opened = where.bus->openToSend(call); !opened)
        return tl::unexpected(opened.error());
    const CanopenAccess::ByHand byHand(*where.bus);
    const auto outcome = readObject(where, what.object);
    if (!outcome)
        return tl::unexpected(outcome.error());
    Answer answer{.json = objectJson(what)};
    if (outcome->kind != Kind::read) {
        answer.complaint = aboutOutcome(where, what, *outcome);
        return answer;
    }
    answer.text = QStringLiteral("%1 = %2\n")
                      .arg(nameOf(what), objectValueText(what, outcome->value, outcome->isSizeTold));
    merge(answer.json, objectValueJson(what, outcome->value, outcome->isSizeTold));
    return answer;
}

// Whether the user wants it, after what it has now was shown.
Checked<void> askToWriteObject(const Call &call, const NodeMeant &where, const ObjectArgument &what,
                               const std::vector<std::uint8_t> &octets,
                               const std::optional<canopen::SdoOutcome> &before)
{
    QString shown =
        sentence(CommandLine::tr("Node %1: %2 := %3"),
                 {CanopenAddress{where.node()}.shown(), nameOf(what), objectValueText(what, octets, true)});
    if (before && before->kind == Kind::read)
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
    const bool mayBeWritten = outcome.kind == Kind::written || outcome.kind == Kind::noAnswer;
    const bool isReadBack = mayBeWritten && !isCounted(what.object);
    const auto after =
        isReadBack ? readObject(where, what.object, WhenStopped::goesOn) : Checked<canopen::SdoOutcome>();
    const bool isKnown = isReadBack && after && after->kind == Kind::read;
    const bool wasThere = before.kind == Kind::read && std::ranges::equal(before.value, octets);
    const bool tells = outcome.kind == Kind::written || !wasThere; // otherwise it is the value of before
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
    if (outcome.kind == Kind::written && !isKnown)
        return told(QStringLiteral("accepted"), CommandLine::tr("Accepted, not read back."));
    const bool isAsBefore = isKnown && before.kind == Kind::read && before.value == after->value;
    if (outcome.kind == Kind::written || (isKnown && !isAsBefore)) {
        answer.json.insert(QStringLiteral("fate"), QStringLiteral("other"));
        answer.complaint = {ExitCode::refused, QStringLiteral("otherReadBack"),
                            sentence(CommandLine::tr("Another value is read back: %1."),
                                     {objectValueText(what, after->value, after->isSizeTold)})};
        return;
    }
    const QString object = what.object.text();
    answer.json.insert(QStringLiteral("fate"), outcome.kind == Kind::notSent   ? QStringLiteral("notSent")
                                               : outcome.kind == Kind::aborted ? QStringLiteral("refused")
                                               : isKnown && tells              ? QStringLiteral("notDone")
                                                                               : QStringLiteral("unknown"));
    if (outcome.kind != Kind::noAnswer)
        answer.complaint = aboutOutcome(where, what, outcome);
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

Checked<Answer> runOdWrite(const Call &call, const NodeMeant &where, const ObjectArgument &what)
{
    if (!what.value)
        return badInput(QStringLiteral("valueMissing"),
                        CommandLine::tr("Give the value behind the object, as %1=1000."),
                        {what.object.text()});
    if (const auto opened = where.bus->openToSend(call); !opened)
        return tl::unexpected(opened.error());
    const auto before = readForWriting(where, what.object);
    if (!before)
        return tl::unexpected(before.error());
    if (before->kind == Kind::noAnswer || before->kind == Kind::notSent)
        return tl::unexpected(aboutOutcome(where, what, *before));
    const bool isSized = before->kind == Kind::read && before->isSizeTold;
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
                       before->kind == Kind::read
                           ? objectValueJson(what, before->value, before->isSizeTold)[u"value"]
                           : QJsonValue());
    tellWritten(where, what, *octets, *before, *outcome, answer);
    return answer;
}

Checked<Answer> runOd(const Call &call)
{
    const QStringList &words = call.arguments.rest;
    const bool reads = words[1] == QStringLiteral("read");
    if (!reads && words[1] != QStringLiteral("write"))
        return badInput(QStringLiteral("odActionWrong"),
                        CommandLine::tr("\"%1\" is not possible. Write read or write."), {words[1]});
    const auto where = nodeMeant(call, words[0]);
    if (!where)
        return tl::unexpected(where.error());
    const auto device = deviceOnNode(call, where->place);
    if (!device)
        return tl::unexpected(device.error());
    const QString key = device->isEmpty() ? usualDeviceOnNode() : *device;
    const auto what = objectArgument(call, words[2], call.catalog.find(key));
    if (!what)
        return tl::unexpected(what.error());
    auto answer = reads ? runOdRead(call, *where, *what) : runOdWrite(call, *where, *what);
    if (answer)
        addPlace(answer->json, call, where->place);
    return answer;
}

} // namespace

const Subcommand odCommand{
    .name = "od",
    .usage = "PLACE read|write OBJECT[=VALUE] [--type TYPE] [--yes]",
    .summary = QT_TRANSLATE_NOOP("codewheel::CommandLine", "read or write an object of a node on CANopen"),
    .details = QT_TRANSLATE_NOOP(
        "codewheel::CommandLine",
        "OBJECT is INDEX[:SUB], the index in hexadecimal as manuals have it: 6004, 1018:4. VALUE is a "
        "number,\n"
        "in decimal or as 1388h, or a text. How wide the object is, the node tells, or --type. What the\n"
        "number means is not looked into: to write parameters of an encoder by name there is write.\n"
        "\n"
        "Before it is written, the object is read and shown, and the write is asked for; where nobody can "
        "be\n"
        "asked, --yes is needed. It is sent once, and read back. A write to 1010h or 1011h counts as a "
        "write\n"
        "to the EEPROM."),
    .examples = odExamples,
    .options = odOptions,
    .arguments = {3},
    .needsBus = true,
    .textIsAccount = true,
    .run = runOd,
};

} // namespace codewheel
