// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/buses.h"
#include "catalog/catalog.h"
#include "cli/bus/bus_access.h"
#include "cli/bus/places.h"
#include "cli/call/texts.h"
#include "cli/commands.h"
#include "cli/encoder/eeprom_consent.h"
#include "cli/encoder/jobs.h"
#include "cli/encoder/told_mode.h"
#include "cli/project/project_of_call.h"
#include "cli/project/transfer_call.h"
#include "cli/project/transfer_text.h"
#include "journal/ledger_keeper.h"
#include "project/project_file.h"
#include "transfer/last_positions.h"
#include "transfer/project_places.h"
#include "transfer/replacement.h"
#include "transfer/transfer_words.h"
#include "vocabulary/hex.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"

#include <array>

namespace codewheel {
namespace {

constexpr const char *replaceExamples[] = {
    "replace 1.0 --project crane.codewheel --label OCD-IBA1B-1213-C100-PRI --serial 4711 --position last",
    "replace Hoist --project crane.codewheel --dry-run"};

constexpr std::array replaceOptions{
    Option{"--device", "NAME",
           QT_TRANSLATE_NOOP("codewheel::CommandLine",
                             "the new encoder: a name of \"devices\"; else it is like the previous one")},
    Option{"--label", "KEY",
           QT_TRANSLATE_NOOP("codewheel::CommandLine", "the new encoder: the key on its label")},
    Option{"--serial", "NUMBER",
           QT_TRANSLATE_NOOP("codewheel::CommandLine", "the serial number on the label of the new encoder")},
    Option{"--position", "N",
           QT_TRANSLATE_NOOP("codewheel::CommandLine",
                             "set the position to this, in steps; \"last\" is the one the project knows")},
    inPositionModeOption,
    transferDryRun,
    transferReport,
    traceOption,
    transferYes,
    beyondLimitOption,
    ledgerOption,
};

Checked<ProjectDevice> plannedAt(const Call &call, Place place)
{
    if (const ProjectDevice *planned = findDevice(*call.project, place))
        return *planned;
    return tl::unexpected(noSuchDevice(place.shown(), devicesOfLink(call, *call.project)));
}

Checked<NamedDevice> newDevice(const Call &call, const ProjectDevice &planned)
{
    const Place place = planned.place();
    const auto named = call.arguments.value("--device");
    const auto label = call.arguments.value("--label");
    if (named && label)
        return badInput("deviceAndLabel",
                        CommandLine::tr("Give --device or --label, not both: each names the new encoder."));
    if (named || label)
        return deviceMeant(call, place, label.value_or(named.value_or(QString())));
    if (planned.participant.deviceKey.isEmpty())
        return badInput("deviceNotNamed",
                        CommandLine::tr("The project does not name the encoder at %1. Name the new one with "
                                        "--device or --label."),
                        {place.shown()});
    return NamedDevice{planned.participant.deviceKey, planned.label.turns, planned.label.stepsPerTurn};
}

Checked<Replacement> replacementMeant(const Call &call, const ProjectDevice &planned)
{
    const auto meant = newDevice(call, planned);
    if (!meant)
        return tl::unexpected(meant.error());
    const DeviceDescription *device = call.catalog.find(meant->key);
    if (device == nullptr)
        return tl::unexpected(deviceMeant(call, planned.place(), meant->key).error());
    if (const auto can = call.buses.busOf(planned.place())->canBe(planned.place(), *device); !can)
        return tl::unexpected(complaintAbout(can.error()));
    if (!device->capabilities.writes)
        return tl::unexpected(complaintAbout(
            {RefusalKind::notSupported, RefusalId::writingNotSupported, {device->fullName()}}));
    return Replacement{device, meant->turns, meant->stepsPerTurn,
                       call.arguments.value("--serial").value_or(QString()).trimmed()};
}

Checked<std::optional<std::int64_t>> positionMeant(const Call &call, const ProjectDevice &planned)
{
    const auto typed = call.arguments.value("--position");
    if (!typed)
        return std::nullopt;
    if (*typed == QStringLiteral("last")) {
        if (planned.lastPosition)
            return planned.lastPosition->position;
        return badInput("noLastPosition",
                        CommandLine::tr("The project knows no last position of %1. Give it as a number."),
                        {planned.place().shown()});
    }
    const auto position = parseNumber(*typed);
    if (!position)
        return badInput("badPosition",
                        CommandLine::tr("\"%1\" is not a position. Give a whole number, 0 or more."),
                        {*typed});
    return position;
}

// The new one is in place, whatever becomes of the writing.
Checked<void> putIntoProject(const Call &call, const ProjectDevice &planned, const Replacement &now,
                             std::optional<std::int64_t> position)
{
    Project project = *call.project;
    if (ProjectDevice *device = findDevice(project, planned.place()))
        *device = replaced(planned, now, position);
    const QString file = *call.arguments.value("--project");
    if (auto saved = saveUnlessChanged(project, file, projectMark(*call.project)); !saved)
        return saved;
    if (LedgerKeeper *ledger = call.busOf(planned.place()).ledger())
        ledger->setLabel(planned.place(), now.serialNumber);
    return {};
}

// The encoder reports another one than was typed.
Checked<void> checkSerial(const Call &call, Place place, const Replacement &now)
{
    const auto other = call.buses.busOf(place)->isOther(place, now.device->key, now.serialNumber);
    if (!other || other->id != RefusalId::serialDiffers)
        return {};
    return tl::unexpected(Complaint{
        ExitCode::refused, refusalKey(other->id),
        sentence(
            CommandLine::tr("The encoder at %1 reports the serial number %3, and --serial is %2. Nothing was "
                            "written, and the project is unchanged: correct --serial, or leave it out."),
            argumentTexts(other->arguments)),
        other->arguments});
}

// What the position is worth with the scale that is written; empty: as much as before.
QString scaleOfLastText(const LastPosition &last, const ParameterValues &settings)
{
    if (isOfAnotherScale(last.scale, settings))
        return CommandLine::tr(
            "It is of another scale than the one of the project: with that, it is another position.");
    if (!isScaleKnown(last.scale))
        return CommandLine::tr(
            "How the encoder was scaled then is not known: it is right if its scale was the same.");
    return isScaleKnown(last.scale, settings)
               ? QString()
               : CommandLine::tr(
                     "How the encoder was scaled then is not known in full: it is right if all of "
                     "its scale was the same.");
}

void showLastPosition(const Call &call, const ProjectDevice &planned, const Replacement &now)
{
    const LastPosition &last = *planned.lastPosition;
    QStringList sentences{
        sentence(CommandLine::tr("The position that the project keeps: %1, seen at %2."),
                 {QString::number(last.position), last.at.toLocalTime().toString(Qt::ISODate)})};
    if (const QString scale = scaleOfLastText(last, settingsOfNew(planned, now.device)); !scale.isEmpty())
        sentences << scale;
    call.terminal.print(sentences.join(u' ') + u'\n');
}

void showDifferences(const Call &call, const ProjectDevice &planned, const Replacement &now)
{
    if (call.arguments.has("--json"))
        return;
    if (call.arguments.value("--position") == QStringLiteral("last"))
        showLastPosition(call, planned, now);
    const auto differences = differencesOf(planned, call.catalog.find(planned.participant.deviceKey), now);
    const QStringList lines = differences.areNone()
                                  ? QStringList{CommandLine::tr(
                                        "It fits: as far as the project shows, it is like the previous one.")}
                                  : transfer_words::differences(differences, now);
    call.terminal.print(lines.join(u'\n') + u'\n');
}

Checked<Answer> runReplace(const Call &call)
{
    if (call.project == nullptr)
        return badInput("missingProject",
                        CommandLine::tr("Name the project with --project FILE: the values are taken from it, "
                                        "and the new encoder is put into it."));
    const auto encoder = encoderAt(call, call.arguments.rest.front());
    if (!encoder)
        return tl::unexpected(encoder.error());
    const Place place = (*encoder)->place();
    const auto planned = plannedAt(call, place);
    if (!planned)
        return tl::unexpected(planned.error());
    const ProjectPlaces places(*call.project, call.buses);
    if (const auto why = places.hindranceToReplace(place))
        return tl::unexpected(complaintAbout(*why));
    const auto now = replacementMeant(call, *planned);
    if (!now)
        return tl::unexpected(now.error());
    const auto position = positionMeant(call, *planned);
    if (!position)
        return tl::unexpected(position.error());

    // Nothing known of the old encoder may be taken for the new one's.
    EncoderBus &bus = *call.buses.busOf(place);
    if (const auto named = bus.replace(place, now->device->key, now->turns, now->stepsPerTurn); !named)
        return tl::unexpected(complaintAbout(named.error()));
    if (const auto there = contactAll(call, {*planned}); !there)
        return tl::unexpected(there.error());
    if (const auto checked = checkSerial(call, place, *now); !checked)
        return tl::unexpected(checked.error());
    showDifferences(call, *planned, *now);
    TransferWish wish = wishToReplace(*planned, *now, *position, places);
    wish.newEncoder.reset(); // it has been named above: what is known of it by now is its own
    const auto toWrite = plan(call, {wish});
    if (!toWrite)
        return tl::unexpected(toWrite.error());
    const auto agreed = [&] {
        return toWrite->front().hindrance ? Checked<void>() : putIntoProject(call, *planned, *now, *position);
    };
    Answer answer =
        transfer(call, TransferKind::replace, *call.arguments.value("--project"), *toWrite, agreed);
    answer.json.insert(QStringLiteral("device"), now->device->key);
    answer.json.insert(QStringLiteral("deviceBefore"), planned->participant.deviceKey);
    answer.json.insert(
        QStringLiteral("differences"),
        differencesJson(differencesOf(*planned, call.catalog.find(planned->participant.deviceKey), *now)));
    return answer;
}

} // namespace

const Subcommand replaceCommand{
    .name = "replace",
    .usage = "PLACE --project FILE [--device NAME | --label KEY] [--serial NUMBER] [--position N] "
             "[--in-position-mode] [--dry-run] "
             "[--report FILE] [--yes] [--trace]",
    .summary = QT_TRANSLATE_NOOP("codewheel::CommandLine",
                                 "give a new encoder the values and the position of the previous one"),
    .details = QT_TRANSLATE_NOOP(
        "codewheel::CommandLine",
        "Tells how the new encoder differs from the one the project has at PLACE, shows what will be "
        "written,\n"
        "asks, puts the new one into the project (make, label and serial number; the file that was there is\n"
        "kept as FILE~), and writes what the project wants, and where nothing is wanted what was stored of "
        "the\n"
        "one before. With --position the position is set at the end of it: the shaft must stand where it "
        "stood\n"
        "then. The old zero offset is not written in that case, since setting the position makes a new one.\n"
        "An encoder with several modes is brought to position mode first. Exit code 1 if the encoder has "
        "not\n"
        "got all of it."),
    .examples = replaceExamples,
    .options = replaceOptions,
    .arguments = {1},
    .needsBus = true,
    .textIsAccount = true,
    .run = runReplace,
};

} // namespace codewheel
