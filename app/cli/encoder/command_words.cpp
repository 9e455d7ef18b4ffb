// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bus/places.h"
#include "cli/call/json.h"
#include "cli/call/texts.h"
#include "cli/commands.h"
#include "cli/encoder/eeprom_consent.h"
#include "cli/encoder/jobs.h"
#include "cli/encoder/parameter_arguments.h"

#include <array>

namespace codewheel {
namespace {

constexpr const char *wordsExamples[] = {
    "words 1.0 020000FF 04000001 06000003 08000000 80000000 00000000",
    "words 1.0 20210000 00000000",
    "words 2.0 04004E20 06000001 80000000 --json",
};

constexpr std::array wordsOptions{
    deviceOption,
    budgetYesOption,
    beyondLimitOption,
    ledgerOption,
    Option{
        "--hold", "CYCLES",
        QT_TRANSLATE_NOOP("codewheel::CommandLine", "how long a word stays that nothing acknowledges (3)")},
    Option{"--after-error", "stop|go-on",
           QT_TRANSLATE_NOOP("codewheel::CommandLine",
                             "whether an error of the encoder ends the sequence (stop)")},
};

constexpr int longestHold = 100'000;

Checked<std::vector<Word>> wordsFrom(const QStringList &texts)
{
    std::vector<Word> words;
    for (const QString &text : texts) {
        const auto word = wordFrom(text);
        if (!word)
            return tl::unexpected(word.error());
        words.push_back(*word);
    }
    return words;
}

Checked<SendWords::AfterError> afterErrorFrom(const Arguments &arguments)
{
    const QString text = arguments.value("--after-error").value_or(QStringLiteral("stop"));
    if (text == QStringLiteral("stop"))
        return SendWords::AfterError::stop;
    if (text == QStringLiteral("go-on"))
        return SendWords::AfterError::goOn;
    return badInput("optionNotAllowed", CommandLine::tr("%1 cannot be \"%2\". Allowed are: %3."),
                    {QStringLiteral("--after-error"), text, QStringLiteral("stop, go-on")});
}

Checked<Answer> runWords(const Call &call)
{
    const auto words = wordsFrom(call.arguments.rest.sliced(1));
    if (!words)
        return tl::unexpected(words.error());
    const auto hold = call.arguments.number("--hold", 3, 1, longestHold);
    if (!hold)
        return tl::unexpected(hold.error());
    const auto afterError = afterErrorFrom(call.arguments);
    if (!afterError)
        return tl::unexpected(afterError.error());
    const auto encoder = encoderAt(call);
    if (!encoder)
        return tl::unexpected(encoder.error());

    const SendWords send{.words = *words,
                         .holdCycles = *hold,
                         .afterError = *afterError,
                         .presetStandsUntilItActs = !call.arguments.has("--hold")};
    const auto allowed = eepromConsent(call, **encoder, send, AsksAnyway::no);
    if (!allowed)
        return tl::unexpected(allowed.error());
    const FinishedJob job = runToEnd(call, *allowed);
    Answer answer;
    answer.text = job.trace->text((*encoder)->place()) + u'\n' + eepromWritesLine(job.outcome) +
                  doubtLines(**encoder, job.outcome.inDoubt);
    answer.json = {{QStringLiteral("device"), (*encoder)->device().key},
                   {QStringLiteral("trace"), job.trace->json((*encoder)->place())},
                   {QStringLiteral("eepromWrites"), job.outcome.eepromWrites},
                   {QStringLiteral("leftIn"), stateKey(job.outcome.leftIn)}};
    addPlace(answer.json, call, (*encoder)->place());
    addDoubt(answer.json, **encoder, job.outcome.inDoubt);
    if (!job.outcome.result)
        answer.complaint = complaintAboutEnd(call, **encoder, job.outcome);
    return answer;
}

} // namespace

const Subcommand wordsCommand{
    .name = "words",
    .usage = "PLACE WORD... [--hold CYCLES] [--after-error stop|go-on]",
    .summary =
        QT_TRANSLATE_NOOP("codewheel::CommandLine", "send words as they are, and print what comes back"),
    .details = QT_TRANSLATE_NOOP(
        "codewheel::CommandLine",
        "Sends words as they are, one after the other, and prints a row for each change of OUT or IN.\n"
        "A parameter word stands until the encoder has confirmed it, run (80000000) until it shows a "
        "position\n"
        "or an error, a read-out until it answers; any other word stands for 3 cycles, 40000000 until the\n"
        "position has followed. --hold says otherwise. The FRABA preset (60000000) stands for one cycle,\n"
        "whatever --hold says: it acts in each. An error of the encoder ends the sequence; with\n"
        "--after-error go-on the next word is sent, so that a way out of it can be tried, and the exit code "
        "is\n"
        "1 only where the last word was answered by an error, or the encoder is left in one. Words are\n"
        "hexadecimal, as the manuals print them."),
    .examples = wordsExamples,
    .options = wordsOptions,
    .arguments = {2, ArgumentCount::any},
    .needsBus = true,
    .textIsAccount = true,
    .run = runWords,
};

} // namespace codewheel
