// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bus/places.h"
#include "cli/call/json.h"
#include "cli/call/keys.h"
#include "cli/call/text_table.h"
#include "cli/call/texts.h"
#include "cli/encoder/consent.h"
#include "cli/kinds/canopen/canopen_link_kind.h"
#include "cli/kinds/canopen/device_file_check.h"
#include "cli/kinds/canopen/object_argument.h"
#include "kinds/canopen/eds/compare_files.h"
#include "kinds/canopen/eds/dcf_writer.h"
#include "kinds/canopen/eds/typed_value.h"
#include "kinds/canopen/protocol/canopen_refusals.h"
#include "project/file_access.h"
#include "vocabulary/sentence.h"

#include <QDateTime>
#include <QFileInfo>

#include <algorithm>
#include <array>

namespace codewheel {
namespace {

using canopen::DeviceFile;
using canopen::ObjectDifference;

constexpr const char *edsExamples[] = {"eds rotor.eds --import", "eds rotor.dcf --compare other.dcf",
                                       "eds rotor.eds --read can:5 --save node5.dcf",
                                       "eds rotor.eds --save new.dcf --node 9 --rate 250000"};

constexpr std::array edsOptions{
    Option{"--import", nullptr,
           QT_TRANSLATE_NOOP("codewheel::CommandLine",
                             "describe the encoder by it: it is known and recognised from then on")},
    Option{"--as", "DEVICE",
           QT_TRANSLATE_NOOP("codewheel::CommandLine",
                             "with --import: the form of encoder, where the file does not say it")},
    Option{"--name", "KEY",
           QT_TRANSLATE_NOOP("codewheel::CommandLine",
                             "with --import: the name of the description; else of vendor and product")},
    Option{"--read", "PLACE",
           QT_TRANSLATE_NOOP("codewheel::CommandLine",
                             "read the objects of the node there, and compare them with the file")},
    Option{"--compare", "FILE",
           QT_TRANSLATE_NOOP("codewheel::CommandLine", "compare with this EDS or DCF instead")},
    Option{"--save", "FILE",
           QT_TRANSLATE_NOOP("codewheel::CommandLine",
                             "write a DCF with the values of the file, or those read")},
    Option{"--node", "NUMBER",
           QT_TRANSLATE_NOOP("codewheel::CommandLine", "with --save: the number of the node in the DCF")},
    Option{"--rate", "BD",
           QT_TRANSLATE_NOOP("codewheel::CommandLine", "with --save: the rate in the DCF, in Bd")},
    busOption,
    Option{"--yes", nullptr, QT_TRANSLATE_NOOP("codewheel::CommandLine", "replace a file that is there")},
};

constexpr NamedValue<ObjectDifference::Kind> differenceKeys[] = {
    {"differs", ObjectDifference::Kind::differs},
    {"missing", ObjectDifference::Kind::missing},
    {"additional", ObjectDifference::Kind::additional},
};

QString differenceText(ObjectDifference::Kind kind)
{
    switch (kind) {
    case ObjectDifference::Kind::missing:
        return CommandLine::tr("missing");
    case ObjectDifference::Kind::additional:
        return CommandLine::tr("additional");
    case ObjectDifference::Kind::differs:
        break;
    }
    return CommandLine::tr("differs");
}

QString differenceLines(const std::vector<ObjectDifference> &differences)
{
    using enum TextTable::Align;
    if (differences.empty())
        return CommandLine::tr("All values are the same.") + u'\n';
    TextTable table({left, left, left, right, right});
    for (const ObjectDifference &each : differences)
        table.add({canopen::objectName(each.object), each.name, differenceText(each.kind),
                   orDash(fileValueText(each.value, each.type)),
                   orDash(fileValueText(each.other, each.type))});
    return table.toString();
}

QJsonArray differencesJson(const std::vector<ObjectDifference> &differences)
{
    QJsonArray array;
    for (const ObjectDifference &each : differences) {
        const QString name = canopen::objectName(each.object);
        array.append(QJsonObject{{QStringLiteral("index"), name.section(u':', 0, 0)},
                                 {QStringLiteral("sub"), each.object.sub},
                                 {QStringLiteral("name"), each.name},
                                 {QStringLiteral("comparison"), keyOf(differenceKeys, each.kind)},
                                 {QStringLiteral("value"), fileValueJson(each.value, each.type)},
                                 {QStringLiteral("other"), fileValueJson(each.other, each.type)}});
    }
    return array;
}

// What the node has answered in place of the values of the file.
struct NodeRead
{
    DeviceFile file;
    QJsonArray notRead;
};

void keepAnswer(canopen::FileObject &object, const canopen::SdoOutcome &outcome, NodeRead &node)
{
    object.value.reset();
    if (outcome.kind == canopen::SdoOutcome::Kind::read) {
        object.value = canopen::fileValueOf(object.type, outcome.value);
        return;
    }
    const QString name = canopen::objectName(object.object);
    node.notRead.append(QJsonObject{{QStringLiteral("index"), name.section(u':', 0, 0)},
                                    {QStringLiteral("sub"), object.object.sub},
                                    {QStringLiteral("abortCode"), wordJson(outcome.abortCode)}});
}

Checked<NodeRead> readNode(const Call &call, const QString &place, DeviceFile file)
{
    using Kind = canopen::SdoOutcome::Kind;
    const auto where = nodeMeant(call, place);
    if (!where)
        return tl::unexpected(where.error());
    if (const auto opened = where->bus->openToSend(call); !opened)
        return tl::unexpected(opened.error());
    NodeRead node{.file = std::move(file), .notRead = {}};
    node.file.commissioning.node = where->node();
    if (const int rate = where->bus->session().rate(); rate > 0)
        node.file.commissioning.rate = rate;
    const CanopenAccess::ByHand byHand(*where->bus);
    for (canopen::FileObject &object : node.file.objects) {
        if (object.access == canopen::FileAccess::writeOnly)
            continue;
        call.terminal.showProgress(canopen::objectName(object.object));
        const auto outcome = where->bus->transfer({.node = where->node(), .object = object.object});
        call.terminal.showProgress({});
        if (!outcome)
            return tl::unexpected(outcome.error());
        if (outcome->kind == Kind::noAnswer || outcome->kind == Kind::notSent)
            return tl::unexpected(
                where->bus->complaint({RefusalKind::link,
                                       outcome->kind == Kind::notSent ? CanopenRefusalId::sdoNotSent
                                                                      : CanopenRefusalId::sdoNoAnswer,
                                       {object.object.text(), std::int64_t{where->node()}}}));
        keepAnswer(object, *outcome, node);
    }
    return node;
}

Checked<void> setCommissioning(const Arguments &arguments, canopen::Commissioning &its)
{
    constexpr std::array rates{10'000,  20'000,  50'000,  100'000,  125'000,
                               250'000, 500'000, 800'000, 1'000'000};
    if (arguments.has("--node")) {
        const auto node = arguments.number("--node", 0, 1, 127);
        if (!node)
            return tl::unexpected(node.error());
        its.node = *node;
    }
    if (!arguments.has("--rate"))
        return {};
    const auto rate = arguments.number("--rate", 0, rates.front(), rates.back());
    if (!rate)
        return tl::unexpected(rate.error());
    if (std::ranges::find(rates, *rate) == rates.end())
        return badInput("optionNotAllowed", CommandLine::tr("%1 cannot be \"%2\". Allowed are: %3."),
                        {QStringLiteral("--rate"), QString::number(*rate),
                         listed(rates, [](int each) { return QString::number(each); })});
    its.rate = *rate;
    return {};
}

Checked<void> saveDcf(const Call &call, const QString &path, const DeviceFile &file, Answer &answer)
{
    const QString target = *call.arguments.value("--save");
    const canopen::DcfHead head{.fileName = QFileInfo(target).fileName(),
                                .ofFile = QFileInfo(path).fileName(),
                                .now = QDateTime::currentDateTime()};
    if (const auto saved = replaceFile(target, canopen::dcfOf(file, head), OldFile::goes); !saved)
        return tl::unexpected(complaintAbout(saved.error()));
    answer.text += sentence(CommandLine::tr("Saved in %1."), {target}) + u'\n';
    answer.json.insert(QStringLiteral("saved"), target);
    return {};
}

Checked<void> checkTarget(const Call &call)
{
    const auto target = call.arguments.value("--save");
    return target ? checkTargetFile(call.arguments, *target) : Checked<void>();
}

// What of the file is left out of account: a node or a rate that is none.
Checked<DeviceFile> fileOfCall(const Call &call, const QString &path)
{
    auto file = canopenDeviceFile(path);
    if (file)
        for (const canopen::EdsNote &note : file->refused)
            call.terminal.complain(complaintAboutDeviceFile(path, note).text);
    return file;
}

// The file with which what there is is compared; empty: with none.
Checked<std::optional<DeviceFile>> otherFile(const Call &call)
{
    const auto path = call.arguments.value("--compare");
    if (!path)
        return std::nullopt;
    return fileOfCall(call, *path).map([](DeviceFile &&file) { return std::optional(std::move(file)); });
}

void tellDifferences(const QString &path, const std::vector<ObjectDifference> &differences, bool isFault,
                     Answer &answer)
{
    answer.text += differenceLines(differences);
    answer.json.insert(QStringLiteral("differences"), differencesJson(differences));
    if (isFault && !differences.empty())
        answer.complaint = notDone("filesDiffer",
                                   sentence(CommandLine::tr("%1 differs. Objects that differ: %2."),
                                            {path, QString::number(differences.size())}),
                                   {path});
}

Checked<Answer> runEds(const Call &call)
{
    const QString &path = call.arguments.rest.front();
    const auto place = call.arguments.value("--read");
    const bool isUsed = place || call.arguments.has("--import") || call.arguments.has("--compare") ||
                        call.arguments.has("--save");
    if (!isUsed)
        return checkOfDeviceFile(call, path);
    const auto file = fileOfCall(call, path);
    if (!file)
        return tl::unexpected(file.error());
    if (call.arguments.has("--import"))
        return importDeviceFile(call, path, *file);
    const auto other = otherFile(call);
    if (!other)
        return tl::unexpected(other.error());
    if (const auto can = checkTarget(call); !can)
        return tl::unexpected(can.error());
    Answer answer{.json = {{QStringLiteral("file"), path}}};
    DeviceFile now = *file;
    if (place) {
        auto node = readNode(call, *place, *file);
        if (!node)
            return tl::unexpected(node.error());
        now = std::move(node->file);
        answer.json.insert(QStringLiteral("notRead"), node->notRead);
    }
    if (const auto set = setCommissioning(call.arguments, now.commissioning); !set)
        return tl::unexpected(set.error());
    if (*other)
        tellDifferences(*call.arguments.value("--compare"), compareFiles(now, **other), true, answer);
    else if (place)
        tellDifferences(path, compareFiles(*file, now), false, answer);
    if (call.arguments.has("--save"))
        if (const auto saved = saveDcf(call, path, now, answer); !saved)
            return tl::unexpected(saved.error());
    return answer;
}

} // namespace

const Subcommand edsCommand{
    .name = "eds",
    .usage =
        "FILE [--import [--as DEVICE] [--name KEY]] [--read PLACE] [--compare FILE] [--save FILE [--node "
        "NUMBER] [--rate BD]] [--yes]",
    .summary = QT_TRANSLATE_NOOP("codewheel::CommandLine",
                                 "import, compare and write files of CANopen devices (EDS, DCF)"),
    .details = QT_TRANSLATE_NOOP(
        "codewheel::CommandLine",
        "FILE is an electronic data sheet (EDS) or the configuration of a device (DCF). Without an option it "
        "is\nlisted, as by devices --check.\n\n--read reads every object of the node that the file names, "
        "one "
        "after the other, and writes nothing to it.\nA DCF gets the values that the objects have, but none "
        "of "
        "objects that can only be written, and none whose\nwriting does more than giving a value, such as "
        "storing, restoring and the preset."),
    .examples = edsExamples,
    .options = edsOptions,
    .arguments = {1},
    .busOption = "--read",
    .run = runEds,
};

} // namespace codewheel
