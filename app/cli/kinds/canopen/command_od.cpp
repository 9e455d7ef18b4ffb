// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/catalog.h"
#include "cli/bus/places.h"
#include "cli/call/help.h"
#include "cli/call/json.h"
#include "cli/call/texts.h"
#include "cli/encoder/eeprom_consent.h"
#include "cli/kinds/canopen/canopen_link_kind.h"
#include "cli/kinds/canopen/device_file_check.h"
#include "cli/kinds/canopen/device_on_node.h"
#include "cli/kinds/canopen/object_argument.h"
#include "cli/kinds/canopen/object_writing.h"
#include "kinds/canopen/eds/standard_objects.h"
#include "kinds/canopen/plan/canopen_plan.h"
#include "vocabulary/sentence.h"

#include <QDir>
#include <QFileInfo>

#include <array>

namespace codewheel {
namespace {

// Where the project says, or else beside it. Empty: the project has none.
QString fileOfEncoder(const Call &call, Place place)
{
    const ProjectDevice *planned = call.project != nullptr ? findDevice(*call.project, place) : nullptr;
    const QString file = planned != nullptr ? planned->its<CanopenEncoderSettings>().file : QString();
    if (file.isEmpty() || QFileInfo::exists(file))
        return file;
    const QDir folder = QFileInfo(*call.arguments.value("--project")).dir();
    const QString beside = folder.filePath(QFileInfo(file).fileName());
    return QFileInfo::exists(beside) ? beside : file;
}

struct PlannedObjectsOfNode
{
    canopen::DeviceFile objects;
    QString from; // the sentence
};

PlannedObjectsOfNode describedObjectsOf(const DeviceDescription *device)
{
    const bool isMake = device != nullptr && !device->isGeneric();
    return {canopen::describedObjects(device),
            isMake
                ? sentence(CommandLine::tr(
                               "Objects and defaults are those that the description of %1 tells, and of "
                               "CiA 301 and CiA 406."),
                           {device->fullName()})
                : CommandLine::tr(
                      "Objects and defaults are those of CiA 301 and CiA 406, of which no device has all.")};
}

// A file that cannot be read is said, and the description takes its place.
PlannedObjectsOfNode objectsOfFile(const Call &call, const QString &path, const DeviceDescription *device)
{
    auto file = canopenDeviceFile(path);
    if (file)
        return {*std::move(file), sentence(CommandLine::tr("Objects and defaults are those of %1."), {path})};
    call.terminal.complain(file.error().text);
    return describedObjectsOf(device);
}

// What the number of the node is added to.
void resolveNode(canopen::DeviceFile &file, int node)
{
    for (canopen::FileObject &object : file.objects)
        for (auto *value : {&object.factory, &object.minimum, &object.maximum, &object.value})
            if (*value)
                *value = (*value)->at(node);
}

// For `od PLACE`: the objects of the node as they are known without asking it, from the file that the project
// has of the encoder, or else from its description. Opens nothing.
Checked<Answer> answerOfPlannedObjects(const Call &call, const NodeMeant &where)
{
    const auto key = deviceOnNode(call, where.place);
    if (!key)
        return tl::unexpected(key.error());
    const DeviceDescription *device = call.catalog.find(*key);
    const QString path = fileOfEncoder(call, where.place);
    PlannedObjectsOfNode planned =
        path.isEmpty() ? describedObjectsOf(device) : objectsOfFile(call, path, device);
    resolveNode(planned.objects, where.node());
    Answer answer{.json = {{QStringLiteral("objects"), fileObjectsJson(planned.objects)},
                           {QStringLiteral("isRead"), false},
                           {QStringLiteral("device"), key->isEmpty() ? QJsonValue() : QJsonValue(*key)}}};
    answer.text =
        sentence(CommandLine::tr("Node %1: nothing was read."), {CanopenAddress{where.node()}.shown()}) +
        u' ' + planned.from + QStringLiteral("\n\n") + fileObjectLines(planned.objects);
    return answer;
}

constexpr const char *odExamples[] = {"od can:5 read 6004 --link canopen:training",
                                      "od can:5 read 1018:4 --json", "od can:5 write 6001=4096 --yes",
                                      "od can:5 write 1010:1=save", "od can:5 --project crane.codewheel"};

constexpr std::array odOptions{
    Option{"--type", "TYPE",
           QT_TRANSLATE_NOOP("codewheel::CommandLine",
                             "take the object for this: u8, u16, u32, i8, i16, i32 or text")},
    deviceOption,
    beyondLimitOption,
    ledgerOption,
    Option{"--yes", nullptr, QT_TRANSLATE_NOOP("codewheel::CommandLine", "write without asking")},
};

Checked<Answer> runOdRead(const Call &call, const NodeMeant &where, const ObjectArgument &what)
{
    if (what.value)
        return badInput("valueNotRead",
                        CommandLine::tr("An object that is read gets no value. To write it: codewheel-cli od "
                                        "PLACE write %1=VALUE."),
                        {what.object.text()});
    if (const auto opened = where.bus->openToSend(call); !opened)
        return tl::unexpected(opened.error());
    const CanopenAccess::ByHand byHand(*where.bus);
    const auto outcome = where.bus->transfer({.node = where.node(), .object = what.object});
    if (!outcome)
        return tl::unexpected(outcome.error());
    Answer answer{.json = objectJson(what)};
    if (outcome->kind != canopen::SdoOutcome::Kind::read) {
        answer.complaint = aboutObjectOutcome(where, what, *outcome);
        return answer;
    }
    answer.text = QStringLiteral("%1 = %2\n")
                      .arg(objectNameText(what), objectValueText(what, outcome->value, outcome->isSizeTold));
    merge(answer.json, objectValueJson(what, outcome->value, outcome->isSizeTold));
    return answer;
}

Checked<Answer> listObjects(const Call &call, const QString &typed)
{
    const auto where = nodeMeant(call, typed);
    if (!where)
        return tl::unexpected(where.error());
    auto answer = answerOfPlannedObjects(call, *where);
    if (answer)
        addPlace(answer->json, call, where->place);
    return answer;
}

Checked<Answer> runOd(const Call &call)
{
    const QStringList &words = call.arguments.rest;
    if (words.size() == 1)
        return listObjects(call, words[0]);
    if (words.size() == 2)
        return badInput("missingArgument", CommandLine::tr("Something is missing. Usage: codewheel-cli %1"),
                        {callOf(call.command)});
    const bool reads = words[1] == QStringLiteral("read");
    if (!reads && words[1] != QStringLiteral("write"))
        return badInput("odActionWrong", CommandLine::tr("\"%1\" is not possible. Write read or write."),
                        {words[1]});
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
    auto answer = reads ? runOdRead(call, *where, *what) : writeObject(call, *where, *what);
    if (answer)
        addPlace(answer->json, call, where->place);
    return answer;
}

} // namespace

const Subcommand odCommand{
    .name = "od",
    .usage = "PLACE [read|write OBJECT[=VALUE]] [--type TYPE] [--yes]",
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
        "to the EEPROM.\n"
        "\n"
        "Without read or write the objects are listed that the encoder may have, with their defaults: those "
        "of\n"
        "the file that the project has of it, or else of its description. Nothing is read."),
    .examples = odExamples,
    .options = odOptions,
    .arguments = {1, 3},
    .needsBus = true,
    .textIsAccount = true,
    .run = runOd,
};

} // namespace codewheel
