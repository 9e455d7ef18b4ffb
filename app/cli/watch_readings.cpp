// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/watch_readings.h"

#include "bus/encoder_bus.h"
#include "cli/bus_access.h"
#include "cli/json.h"
#include "cli/stop_signals.h"
#include "cli/text_table.h"
#include "cli/texts.h"
#include "encoder/encoder_session.h"
#include "encoder/hex.h"

namespace codewheel {
namespace {

constexpr int timeWidth = 9;
constexpr int positionWidth = 8;

QString row(const QString &time, const QString &hex, const QString &position, const QString &more)
{
    return time.rightJustified(timeWidth) + QStringLiteral("  ") + hex.leftJustified(positionWidth) +
           QStringLiteral("  ") + position.rightJustified(positionWidth) +
           (more.isEmpty() ? QString() : QStringLiteral("  ") + more) + u'\n';
}

QString rowText(const BusAccess &bus, Instant at, const Reading &reading)
{
    const QString hex = reading.position ? hexWord(static_cast<Word>(*reading.position)) : QString();
    const QString position = reading.position ? QString::number(*reading.position) : QStringLiteral("-");
    return row(rowTime(at), hex, position, bus.remarks(reading).join(QStringLiteral(", ")));
}

QJsonObject sampleJson(const BusAccess &bus, Instant at, const Reading &reading)
{
    QJsonObject json = bus.remarksJson(reading);
    json.insert(QStringLiteral("microseconds"), static_cast<qint64>(at.count()));
    json.insert(QStringLiteral("state"), stateKey(reading.state));
    json.insert(QStringLiteral("position"), numberJson(reading.position));
    json.insert(QStringLiteral("suspect"), reading.suspect);
    return json;
}

} // namespace

Answer watchReadings(const Call &call, const EncoderSession &encoder, Instant duration, Instant interval)
{
    BusAccess &bus = call.busOf(encoder.place());
    const Instant begin = bus.bus().now();
    const bool isShown = !call.arguments.has("--json");
    QString shownBefore;
    QJsonObject toldBefore;
    QJsonArray samples;
    const auto look = [&] { // what says the same as the one before is no row, whenever it came
        const Reading &reading = encoder.latest();
        const Instant at = bus.bus().now() - begin;
        if (const QJsonObject told = sampleJson(bus, {}, reading); told != toldBefore) {
            toldBefore = told;
            samples.append(sampleJson(bus, at, reading));
        }
        if (const QString shown = rowText(bus, {}, reading); isShown && shown != shownBefore) {
            shownBefore = shown;
            call.terminal.print(rowText(bus, at, reading));
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
        isConnected = bus.advance(interval);
        look();
    }
    Answer answer{.json = {{QStringLiteral("samples"), samples}}};
    bus.addFigures(call, encoder, answer);
    return answer;
}

} // namespace codewheel
