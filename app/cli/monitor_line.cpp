// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/monitor_line.h"

#include "cli/json.h"
#include "cli/line_access.h"
#include "cli/line_figures_text.h"
#include "cli/line_trace.h"
#include "cli/stop_signals.h"
#include "cli/texts.h"
#include "encoder/encoder_session.h"
#include "encoder/hex.h"
#include "encoder/refusal_text.h"
#include "esc/esc_bits.h"

namespace codewheel {
namespace {

constexpr int timeWidth = 9;
constexpr int positionWidth = 8;

QStringList remarks(const Reading &reading)
{
    QStringList texts;
    if (reading.state == EncoderState::silent)
        texts << CommandLine::tr("does not answer");
    if (reading.suspect)
        texts << CommandLine::tr("suspect: asked for again");
    if (reading.alarms)
        texts << esc::bitTexts(esc::Command::alarms, *reading.alarms);
    if (reading.warnings)
        texts << esc::bitTexts(esc::Command::warnings, *reading.warnings);
    return texts;
}

QString row(const QString &time, const QString &hex, const QString &position, const QString &more)
{
    return time.rightJustified(timeWidth) + QStringLiteral("  ") + hex.leftJustified(positionWidth) +
           QStringLiteral("  ") + position.rightJustified(positionWidth) +
           (more.isEmpty() ? QString() : QStringLiteral("  ") + more) + u'\n';
}

QString rowText(Instant at, const Reading &reading)
{
    const QString hex = reading.position ? hexWord(static_cast<Word>(*reading.position)) : QString();
    const QString position = reading.position ? QString::number(*reading.position) : QStringLiteral("-");
    return row(rowTime(at), hex, position, remarks(reading).join(QStringLiteral(", ")));
}

QJsonValue bitsOrNull(esc::Command command, const std::optional<std::uint16_t> &word)
{
    return word ? QJsonValue(bitsJson(command, *word)) : QJsonValue();
}

QJsonObject sampleJson(Instant at, const Reading &reading)
{
    return {{QStringLiteral("microseconds"), static_cast<qint64>(at.count())},
            {QStringLiteral("state"), stateKey(reading.state)},
            {QStringLiteral("position"), numberJson(reading.position)},
            {QStringLiteral("suspect"), reading.suspect},
            {QStringLiteral("alarms"), bitsOrNull(esc::Command::alarms, reading.alarms)},
            {QStringLiteral("warnings"), bitsOrNull(esc::Command::warnings, reading.warnings)}};
}

} // namespace

Answer monitorLine(const Call &call, const EncoderSession &encoder, Instant duration, Instant interval)
{
    const LineSession &line = **call.line->session();
    const Instant begin = line.latest().at;
    const bool isShown = !call.arguments.has("--json");
    QString shownBefore;
    QJsonObject toldBefore;
    QJsonArray samples;
    const auto look = [&] { // what says the same as the one before is no row, whenever it came
        const Reading &reading = encoder.latest();
        const Instant at = line.latest().at - begin;
        if (const QJsonObject told = sampleJson({}, reading); told != toldBefore) {
            toldBefore = told;
            samples.append(sampleJson(at, reading));
        }
        if (const QString shown = rowText({}, reading); isShown && shown != shownBefore) {
            shownBefore = shown;
            call.terminal.print(rowText(at, reading));
        }
    };

    if (isShown)
        call.terminal.print(row(QStringLiteral("ms"), QStringLiteral("hex"), CommandLine::tr("position"),
                                CommandLine::tr("alarms and warnings")));
    look();
    StopSignals stop;
    bool isConnected = true;
    const auto goesOn = [&] { return isConnected && call.terminal.canPrint() && !stop.came(); };
    for (Instant passed = interval; passed <= duration && goesOn(); passed += interval) {
        isConnected = call.line->advance(interval);
        look();
    }
    Answer answer;
    const LineFigures figures = line.shown(encoder.place())->figures;
    answer.text = u'\n' + figuresText(figures);
    answer.json = {{QStringLiteral("samples"), samples}, {QStringLiteral("figures"), figuresJson(figures)}};
    if (line.latest().lowLatency == LowLatency::refused)
        call.terminal.complain(
            messageText({.id = MessageId::lowLatencyRefused, .arguments = {line.linkName()}}));
    if (!isConnected)
        answer.complaint = call.line->portLost();
    return answer;
}

} // namespace codewheel
