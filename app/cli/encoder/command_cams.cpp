// SPDX-License-Identifier: GPL-3.0-or-later
#include "cams/cam_file.h"
#include "cams/check_cams.h"
#include "catalog/catalog.h"
#include "catalog/total_range.h"
#include "cli/bus/bus_access.h"
#include "cli/bus/places.h"
#include "cli/call/texts.h"
#include "cli/commands.h"
#include "cli/encoder/cam_text.h"
#include "cli/encoder/consent.h"
#include "cli/encoder/eeprom_consent.h"
#include "cli/encoder/jobs.h"
#include "cli/encoder/mode_left.h"
#include "cli/encoder/position_text.h"
#include "jobs/value_notes.h"
#include "jobs/values_to_write.h"
#include "project/file_access.h"
#include "vocabulary/hex.h"
#include "vocabulary/sentence.h"

#include <algorithm>
#include <array>

namespace codewheel {
namespace {

constexpr const char *camsExamples[] = {"cams 1.0 read", "cams 1.0 read cams.json --program 1",
                                        "cams 1.0 compare docs/examples/cams.json",
                                        "cams 1.0 write docs/examples/cams.json --yes"};

constexpr std::array camsOptions{
    deviceOption,
    beyondLimitOption,
    ledgerOption,
    Option{"--program", "N", QT_TRANSLATE_NOOP("codewheel::CommandLine", "only this cam program, 1 to 8")},
    Option{"--stay", nullptr,
           QT_TRANSLATE_NOOP("codewheel::CommandLine",
                             "leave the encoder in cam mode, in the last of the programs")},
    Option{"--to-position", nullptr,
           QT_TRANSLATE_NOOP("codewheel::CommandLine",
                             "switch the encoder to position mode afterwards, whatever mode it was in")},
    Option{"--yes", nullptr,
           QT_TRANSLATE_NOOP("codewheel::CommandLine", "write without asking, also where the budget of the "
                                                       "EEPROM is used; replace FILE when reading")},
    traceOption,
};

// It stays where nobody said where to, and the mode before is not known.
QString hintAtPosition(const Arguments &arguments, const ModeLeft &left)
{
    const bool staysUnasked = !left.hasFailed && left.now.mode == Mode::cam && !left.before.mode &&
                              !arguments.has("--stay") && !arguments.has("--to-position");
    return staysUnasked ? u' ' + CommandLine::tr("With --to-position it is in position mode afterwards.")
                        : QString();
}

// What a job about cams has written.
QString accountText(const Outcome &outcome)
{
    if (outcome.camsWritten.empty())
        return {};
    const QString numbers = listed(outcome.camsWritten,
                                   [](const CamProgram &program) { return QString::number(program.number); });
    return sentence(CommandLine::tr("Written and read back: cam program %1."), {numbers}) + u'\n';
}

// One call in progress: what it is about, and what it has to say so far.
struct CamCall
{
    const Call &call;
    EncoderSession &encoder;
    LeftMode modeBefore = modeShown(encoder);
    ModeLeft left{};
    Answer answer{};
    std::unique_ptr<JobTrace> trace{};
    int writesBefore = encoder.eepromWrites(); // of this session
    int perhapsWrites = 0;                     // by all its jobs
    bool hasSwitched = false;                  // to cam mode, and back if all went well

    // What it has done is told; if it failed, the answer says why.
    Outcome carryOut(const AllowedJob &job)
    {
        const LeftMode atStart = modeShown(encoder);
        Outcome outcome = runToEnd(call, job, *trace);
        left = modeLeft(encoder, outcome, modeBefore, atStart);
        if (!std::holds_alternative<ReadParameters>(job.job())) {
            hasSwitched = true;
            answer.text += accountText(outcome);
        }
        answer.text += doubtLines(encoder, outcome.inDoubt);
        addToJson(outcome);
        if (!outcome.result) {
            answer.complaint = complaintAboutJob(call, encoder.place(), outcome.result.error());
            answer.complaint->text += u' ' + whereItWasLeft(outcome, encoder.latest());
        }
        return outcome;
    }
    // Only the last job can leave more in doubt than writes.
    void addToJson(const Outcome &outcome)
    {
        perhapsWrites += outcome.inDoubt.eepromWrites;
        InDoubt doubt = outcome.inDoubt;
        doubt.eepromWrites = perhapsWrites;
        addDoubt(answer.json, encoder, doubt);
        if (hasSwitched)
            answer.json.insert(QStringLiteral("eepromWrites"), eepromWrites());
    }
    // As the ledger counts them.
    int eepromWrites() const { return encoder.eepromWrites() - writesBefore; }
    void addWrites()
    {
        if (left.hasFailed || eepromWrites() + perhapsWrites > 0)
            answer.text += eepromWritesLine(eepromWrites(), perhapsWrites);
    }
    // Back to where it was, as far as known; otherwise it stays in the last program, which is saved.
    SwitchMode afterwards(const std::vector<unsigned> &programs) const
    {
        if (call.arguments.has("--to-position"))
            return {};
        const SwitchMode last{Mode::cam, programs.back()};
        const bool staysInLast = call.arguments.has("--stay") || !modeBefore.mode ||
                                 (modeBefore.mode == Mode::cam && !modeBefore.camProgram);
        return staysInLast ? last : SwitchMode{*modeBefore.mode, modeBefore.camProgram.value_or(0)};
    }
    // In which mode it is now, and why.
    void addMode()
    {
        left.addTo(answer.json);
        if (encoder.device().mayHaveModes())
            answer.text += left.toText() + hintAtPosition(call.arguments, left) + u'\n';
    }
    std::optional<std::int64_t> positions() const
    {
        return totalRange(encoder.device(), valuesOf(allKnown(encoder)));
    }
    void show()
    {
        if (!call.arguments.has("--json"))
            call.terminal.print(std::exchange(answer.text, {}));
    }
    // To what reading may cost, in the mode it is in or may be in.
    Checked<void> agreesToRead()
    {
        const QString leaving = costOfLeaving(encoder);
        if (leaving.isEmpty())
            return {};
        answer.text += CommandLine::tr("The cam programs are read in cam mode.") + u'\n' +
                       sentence(CommandLine::tr("EEPROM writes:   %1"), {QStringLiteral("0")}) + leaving +
                       u'\n';
        show();
        return consent(call,
                       sentence(CommandLine::tr("Read the cam programs of %1?"), {encoder.place().shown()}),
                       CommandLine::tr("Nothing was sent: there is nobody to ask. Add --yes to read them."));
    }
    // What scales the position, as far as the encoder has it.
    std::vector<Parameter> scaleParameters() const
    {
        std::vector<Parameter> parameters{Parameter::steps, Parameter::revolutions};
        std::erase_if(parameters, [this](Parameter one) { return encoder.device().find(one) == nullptr; });
        return parameters;
    }
    // Costs EEPROM writes if a program was changed before. Empty: the answer says why.
    std::optional<std::vector<CamProgram>> readPrograms(const std::vector<unsigned> &programs)
    {
        if (const auto agreed = agreesToRead(); !agreed) {
            answer.complaint = agreed.error();
            return std::nullopt;
        }
        const auto allowed =
            eepromConsent(call, encoder, ReadCams{programs, afterwards(programs)}, AsksAnyway::no);
        if (!allowed) {
            answer.complaint = allowed.error();
            return std::nullopt;
        }
        Outcome read = carryOut({encoder, ReadParameters{scaleParameters()}});
        if (read.result)
            read = carryOut(*allowed);
        if (!read.result)
            return std::nullopt;
        std::ranges::sort(read.camsRead, {}, &CamProgram::number);
        return read.camsRead;
    }
};

Checked<std::optional<unsigned>> programFrom(const Arguments &arguments)
{
    const auto text = arguments.value("--program");
    if (!text)
        return std::nullopt;
    bool isNumber = false;
    const int number = text->toInt(&isNumber);
    if (!isNumber)
        return badInput("notANumber",
                        CommandLine::tr("\"%1\" is not a number of a cam program. Choose one from 1 to 8."),
                        {*text});
    if (const auto checked = checkCamProgramNumber(number); !checked)
        return tl::unexpected(complaintAbout(checked.error()));
    return static_cast<unsigned>(number);
}

// From the file: all its programs, or the one wanted.
Checked<CamFile> programsIn(const QString &name, std::optional<unsigned> program)
{
    auto cams = readWholeFile(name, largestCamFile).and_then([&](const QByteArray &json) {
        return camFileFromJson(json, name);
    });
    if (!cams)
        return tl::unexpected(complaintAbout(cams.error()));
    if (!program)
        return *std::move(cams);
    const auto one = camProgramOf(*cams, *program, name);
    if (!one)
        return tl::unexpected(complaintAbout(one.error()));
    cams->programs = {*one};
    return *std::move(cams);
}

Checked<void> checkMadeFor(const Call &call, const CamFile &file, const DeviceDescription &encoder)
{
    const QString &name = call.arguments.rest[2];
    if (suits(file, encoder, call.catalog.find(file.device)))
        return {};
    return tl::unexpected(Complaint{ExitCode::badInput,
                                    QStringLiteral("camFileOfOtherDevice"),
                                    otherDeviceText(file, encoder, name),
                                    {name, file.device, encoder.key}});
}

// A read must not overwrite a file, and nothing is read that could not be saved.
Checked<void> checkCamFile(const Arguments &arguments)
{
    if (arguments.rest.size() < 3)
        return {};
    return checkTargetFile(
        arguments, arguments.rest[2],
        CommandLine::tr("%1 is there already. Nothing was read. Name another file, or add --yes to "
                        "replace it."));
}

void saveCams(CamCall &cams, const QString &name, std::vector<CamProgram> programs)
{
    const QByteArray json = camFileToJson({cams.encoder.device().key, cams.positions(), std::move(programs)});
    if (const auto saved = replaceFile(name, json, OldFile::goes); !saved)
        cams.answer.complaint = complaintAbout(saved.error());
    else
        cams.answer.text += sentence(CommandLine::tr("Saved in %1."), {name}) + u'\n';
}

void read(CamCall &cams, std::optional<unsigned> program)
{
    const auto programs =
        program ? std::vector{*program} : programNumbers(cams.encoder.can().cams.value_or(CamAbilities()));
    const auto read = cams.readPrograms(programs);
    if (!read)
        return;
    cams.answer.text += camTable(*read);
    cams.answer.json.insert(QStringLiteral("programs"), camsJson(*read));
    if (cams.call.arguments.rest.size() > 2)
        saveCams(cams, cams.call.arguments.rest[2], *read);
}

// Reads the programs of the file from the encoder, and reports the differences.
std::optional<std::vector<CamDifference>> compareWith(CamCall &cams, const std::vector<CamProgram> &wanted)
{
    const auto read = cams.readPrograms(numbersOf(wanted));
    if (!read)
        return std::nullopt;
    auto differences = differencesOf(cams.encoder.device(), *read, wanted);
    cams.answer.json.insert(QStringLiteral("differences"), differencesJson(differences));
    cams.answer.text += differences.empty() ? CommandLine::tr("The encoder has all of it.") + u'\n'
                                            : differenceTable(differences);
    return differences;
}

void compare(CamCall &cams, const std::vector<CamProgram> &wanted)
{
    const auto differences = compareWith(cams, wanted);
    if (differences && !differences->empty())
        cams.answer.complaint =
            notDone("camsDiffer", sentence(CommandLine::tr("The encoder and the file differ in values: %1."),
                                           {QString::number(differences->size())}));
}

QString wordList(const std::vector<Step> &steps)
{
    QStringList words;
    for (const Step &step : steps)
        if (!readsCams(step))
            words << hexWord(step.out);
    return words.join(u' ');
}

// What will be sent besides read-outs.
Result<QString> reviewText(const CamCall &cams, const WriteCams &job)
{
    return cams.encoder.planned({job}).map([](const std::vector<Step> &steps) {
        return sentence(CommandLine::tr("Words to be sent, beside read-outs: %1"), {wordList(steps)}) + u'\n';
    });
}

// What reading them has cost was agreed to before.
QString costText(const std::vector<CamDifference> &differences, int perhapsByReading)
{
    int programs = 0;
    unsigned last = 0;
    for (const CamDifference &one : differences)
        programs += std::exchange(last, one.program) != one.program ? 1 : 0;
    QString text =
        sentence(CommandLine::tr("EEPROM writes: %1, one for each program that is changed and left."),
                 {QString::number(programs)});
    if (perhapsByReading > 0)
        text += u' ' + sentence(CommandLine::tr("Reading has perhaps cost so many: %1."),
                                {QString::number(perhapsByReading)});
    return text + u'\n';
}

void write(CamCall &cams, const std::vector<CamProgram> &wanted)
{
    const auto differences = compareWith(cams, wanted);
    if (!differences || differences->empty())
        return;
    const WriteCams job{.programs = wanted, .afterwards = cams.afterwards(numbersOf(wanted))};
    const auto review = reviewText(cams, job);
    if (!review) {
        cams.answer.complaint = complaintAbout(review.error());
        return;
    }
    cams.answer.text += *review + costText(*differences, cams.perhapsWrites);
    cams.show();
    const auto allowed = eepromConsent(cams.call, cams.encoder, job, AsksAnyway::yes);
    if (!allowed) {
        cams.answer.complaint = allowed.error();
        return;
    }
    const auto agreed = consent(
        cams.call, sentence(CommandLine::tr("Write this to %1?"), {cams.encoder.place().shown()}),
        CommandLine::tr("Nothing was written: there is nobody to ask. Add --yes to write, or use compare "
                        "to look only."));
    if (agreed)
        cams.answer.json.insert(QStringLiteral("written"), camsJson(cams.carryOut(*allowed).camsWritten));
    else
        cams.answer.complaint = agreed.error();
}

Checked<Answer> runCams(const Call &call)
{
    const QString &what = call.arguments.rest[1];
    const bool reads = what == QStringLiteral("read");
    const bool compares = what == QStringLiteral("compare");
    if (!reads && !compares && what != QStringLiteral("write"))
        return badInput("unknownAction", CommandLine::tr("\"%1\" is none of read, write and compare."),
                        {what});
    if (!reads && call.arguments.rest.size() < 3)
        return badInput("missingFile", CommandLine::tr("Name the file of the cam programs."));
    if (call.arguments.has("--stay") && call.arguments.has("--to-position"))
        return badInput(
            "optionsContradict",
            CommandLine::tr("--stay and --to-position contradict each other. Leave out one of them."));
    const auto program = programFrom(call.arguments);
    if (!program)
        return tl::unexpected(program.error());
    if (const auto canSave = reads ? checkCamFile(call.arguments) : Checked<void>(); !canSave)
        return tl::unexpected(canSave.error());
    const auto wanted = reads ? Checked<CamFile>() : programsIn(call.arguments.rest[2], *program);
    if (!wanted)
        return tl::unexpected(wanted.error());
    const auto encoder = encoderAt(call);
    if (!encoder)
        return tl::unexpected(encoder.error());
    if (!(*encoder)->can().cams)
        return tl::unexpected(complaintAbout(
            {RefusalKind::notSupported, RefusalId::camsNotSupported, {(*encoder)->device().fullName()}}));
    if (const auto fits = reads ? Checked<void>() : checkMadeFor(call, *wanted, (*encoder)->device()); !fits)
        return tl::unexpected(fits.error());

    CamCall cams{
        .call = call, .encoder = **encoder, .trace = call.busOf((*encoder)->place()).trace({*encoder})};
    if (reads)
        read(cams, *program);
    else if (compares)
        compare(cams, wanted->programs);
    else
        write(cams, wanted->programs);
    if (cams.hasSwitched) {
        cams.addWrites();
        cams.addMode();
    }
    Answer answer = std::move(cams.answer);
    addPlace(answer.json, call, (*encoder)->place());
    answer.json.insert(QStringLiteral("device"), (*encoder)->device().key);
    const QString text = std::exchange(answer.text, {});
    addTrace(call, (*encoder)->place(), *cams.trace, answer);
    answer.text += text;
    return answer;
}

} // namespace

const Subcommand camsCommand{
    .name = "cams",
    .usage = "PLACE read|write|compare [FILE] [--program N] [--stay | --to-position] [--yes] [--trace]",
    .summary = QT_TRANSLATE_NOOP("codewheel::CommandLine", "read, write and compare cam programs"),
    .details = QT_TRANSLATE_NOOP(
        "codewheel::CommandLine",
        "read prints the cam programs, and saves them in FILE where one is named; a FILE that is there\n"
        "already is replaced with --yes only. compare reads those that are in FILE and tells line by line\n"
        "what differs; exit code 1 if anything does. write does the same, shows the words and the EEPROM\n"
        "writes, asks, writes what differs, and reads it back. A FILE made for another device is refused.\n"
        "\n"
        "Without --program, all eight are read, or all that are in the file. The encoder is in cam mode "
        "meanwhile.\n"
        "Afterwards it is again in the mode it was in, where that is known; else, and with --stay, it stays "
        "in "
        "the\n"
        "last of the programs, and with --to-position it is in position mode. In the end it is told in "
        "which\n"
        "mode it is. A changed program is saved when it is left, with one EEPROM write."),
    .examples = camsExamples,
    .options = camsOptions,
    .arguments = {2, 3},
    .needsBus = true,
    .textIsAccount = true,
    .run = runCams,
};

} // namespace codewheel
