// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/kinds/esc/scan_line.h"

#include "catalog/hex_code.h"
#include "cli/call/json.h"
#include "cli/call/stop_signals.h"
#include "cli/call/text_table.h"
#include "cli/call/texts.h"
#include "cli/encoder/jobs.h"
#include "cli/kinds/esc/esc_line_access.h"
#include "kinds/esc/protocol/esc_refusals.h"
#include "vocabulary/hex.h"
#include "vocabulary/sentence.h"
#include "vocabulary/serial_number_text.h"

namespace codewheel {
namespace {

using namespace std::chrono_literals;

constexpr Instant scanLookInterval = 20ms;
const std::vector<int> ratesOfEncoders{19'200, 9'600, 4'800};

Checked<EscLineAddress> addressOf(const Arguments &arguments, const char *option, std::uint8_t otherwise)
{
    const auto text = arguments.value(option);
    if (!text)
        return EscLineAddress{otherwise};
    const auto address = EscLineAddress::fromWire(*text);
    if (!address || !address->isDevice())
        return tl::unexpected(
            complaintAbout({RefusalKind::badInput, EscRefusalId::lineAddressWrong, {*text}}));
    return *address;
}

Checked<ScanWish> wishOf(const Call &call, const EscLineAccess &line)
{
    ScanWish wish;
    wish.baudRates = call.arguments.has("--all-rates") ? ratesOfEncoders
                                                       : std::vector{line.link().settings.serial.baudRate};
    wish.throughMaster = call.arguments.has("--master");
    const auto first = addressOf(call.arguments, "--first", 1);
    if (!first)
        return tl::unexpected(first.error());
    const auto last = addressOf(call.arguments, "--last", EscLineAddress::last);
    if (!last)
        return tl::unexpected(last.error());
    if (*last < *first)
        return badInput("addressesReversed",
                        CommandLine::tr("The last address, %1, lies before the first, %2."),
                        {last->onWire(), first->onWire()});
    wish.first = *first;
    wish.last = *last;
    return wish;
}

void showProgress(const Call &call, const ScanProgress &progress)
{
    if (!call.arguments.has("--json"))
        call.terminal.showProgress(sentence(CommandLine::tr("Addresses asked: %1 of %2. Encoders found: %3."),
                                            {QString::number(progress.asked), QString::number(progress.total),
                                             QString::number(progress.found.size())}));
}

// The result of the search; empty: the port is gone.
std::optional<ScanEnded> search(const Call &call, EscLineAccess &access, const ScanWish &wish)
{
    EscLineSession &line = access.line();
    std::optional<ScanEnded> ended;
    QObject scope;
    QObject::connect(&line, &EscLineSession::scanProgressed, &scope,
                     [&](const ScanProgress &progress) { showProgress(call, progress); });
    QObject::connect(&line, &EscLineSession::scanEnded, &scope,
                     [&](const ScanEnded &result) { ended = result; });
    StopSignals stop;
    line.scan(wish);
    bool isConnected = true;
    while (!ended && isConnected) {
        isConnected = access.advance(scanLookInterval);
        if (stop.came())
            line.cancelScan();
    }
    call.terminal.showProgress({});
    return isConnected ? ended : std::nullopt;
}

QString tableOf(const std::vector<FoundEncoder> &found)
{
    using enum TextTable::Align;
    TextTable table({left, right, right});
    table.add({CommandLine::tr("place"), CommandLine::tr("address"), QStringLiteral("Bd"),
               CommandLine::tr("serial number"), CommandLine::tr("device code"), CommandLine::tr("version")});
    for (const FoundEncoder &one : found)
        table.add({one.address.onWire(),
                   one.address.isMaster() ? CommandLine::tr("master") : QString::number(one.address.value),
                   QString::number(one.baudRate),
                   orDash(one.serialNumber ? serialNumberText(*one.serialNumber) : QString()),
                   orDash(one.deviceCode ? hexCode(*one.deviceCode, 4) : QString()), orDash(one.version)});
    return table.toString();
}

QJsonObject foundJson(const FoundEncoder &one)
{
    return {{QStringLiteral("address"), one.address.onWire()},
            {QStringLiteral("baudRate"), one.baudRate},
            {QStringLiteral("serialNumber"),
             one.serialNumber ? QJsonValue(hexWord(*one.serialNumber)) : QJsonValue()},
            {QStringLiteral("deviceCode"),
             one.deviceCode ? QJsonValue(static_cast<int>(*one.deviceCode)) : QJsonValue()},
            {QStringLiteral("version"), textJson(one.version)}};
}

Answer scanAnswer(const ScanEnded &ended)
{
    QJsonArray encoders;
    for (const FoundEncoder &one : ended.found)
        encoders.append(foundJson(one));
    Answer answer;
    answer.json = {{QStringLiteral("encoders"), encoders}, {QStringLiteral("requests"), ended.requests}};
    if (!ended.found.empty())
        answer.text = tableOf(ended.found);
    else if (!ended.cancelled)
        answer.text = CommandLine::tr("No encoder answers. Check baud rate (--all-rates), wiring and "
                                      "supply; an RS-422 encoder also needs ST (pin 7) at +UB.") +
                      u'\n';
    if (ended.cancelled)
        answer.complaint =
            notDone("scanCancelled",
                    ended.found.empty()
                        ? CommandLine::tr("The search was cancelled: until then no encoder had answered.")
                        : CommandLine::tr("The search was cancelled: what was found until then is listed."));
    return answer;
}

} // namespace

Checked<void> checkScanOptions(const Call &call, const EscLineAccess &line)
{
    return wishOf(call, line).map([](const ScanWish &) {});
}

Checked<std::optional<FoundEncoder>> whoIsAt(const Call &call, EscLineAccess &line, EscLineAddress address)
{
    if (const auto opened = line.open(); !opened)
        return tl::unexpected(opened.error());
    const auto ended = search(
        call, line, {.baudRates = {line.link().settings.serial.baudRate}, .first = address, .last = address});
    if (!ended)
        return tl::unexpected(line.linkLost());
    if (ended->cancelled)
        return tl::unexpected(aboutCancelling());
    return ended->found.empty() ? std::nullopt : std::optional(ended->found.front());
}

Checked<ScannedLine> scanLine(const Call &call, EscLineAccess &line)
{
    const auto wish = wishOf(call, line);
    if (!wish)
        return tl::unexpected(wish.error());
    if (const auto opened = line.open(); !opened)
        return tl::unexpected(opened.error());
    const auto ended = search(call, line, *wish);
    if (!ended)
        return tl::unexpected(line.linkLost());
    Answer answer = scanAnswer(*ended);
    if (const QString stray = line.strayBytesText(); ended->found.empty() && !stray.isEmpty())
        answer.text += stray + u'\n';
    answer.json.insert(QStringLiteral("strayBytes"), static_cast<qint64>(line.strayBytes()));
    answer.json.insert(QStringLiteral("port"), line.portKey());
    return ScannedLine{std::move(answer), ended->found};
}

} // namespace codewheel
