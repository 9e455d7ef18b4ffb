// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever comes from a serial line, in whatever pieces and at whatever time: an exchange ends, loses no
// byte, and takes only an answer for one. What is typed is either a request that reads back as itself, or
// nothing.
//
// The first byte chooses the command, the second the number of retries of a read; then follow pieces: their
// delay after the previous one in half milliseconds, their length, their bytes.
#include "kinds/esc/protocol/esc_exchange.h"
#include "kinds/esc/protocol/esc_explain.h"
#include "tests/fuzz/must.h"

#include <QByteArrayView>

using namespace codewheel;
using namespace codewheel::esc;

namespace {

constexpr Instant halfMillisecond{500};
constexpr int mostSteps = 100'000;

struct Heard
{
    QByteArray arrived;
    QByteArray told;     // reported by the rows
    QByteArray answered; // likewise, only the answer
    int sendings = 0;
    bool done = false;
};

void readRows(Exchange &exchange, Heard &heard)
{
    for (const EscLineRow &row : exchange.takeRows()) {
        if (row.kind != EscLineRow::Kind::sent)
            heard.told += row.bytes;
        if (row.kind == EscLineRow::Kind::answer)
            heard.answered += row.bytes;
    }
}

// Lets the exchange do what it wants until then.
void passUntil(Exchange &exchange, Instant &now, Instant until, Heard &heard)
{
    for (int step = 0;; ++step) {
        must(step < mostSteps, "it goes on");
        const Exchange::Action action = exchange.next(now);
        readRows(exchange, heard);
        if (std::holds_alternative<Exchange::Send>(action)) {
            ++heard.sendings;
        } else if (const auto *wait = std::get_if<Exchange::Wait>(&action)) {
            must(wait->until > now, "it waits for something to come");
            if (wait->until >= until) {
                now = until;
                return;
            }
            now = wait->until;
        } else {
            heard.done = true;
            now = std::max(now, until);
            return;
        }
    }
}

void mustBeWellFormed(const Exchange &exchange, const Heard &heard)
{
    const auto &answer = exchange.result().answer;
    must(answer.has_value() || heard.answered.isEmpty(), "no answer");
    if (!answer)
        return;
    const CommandShape &shape = shapeOf(exchange.request().command);
    switch (answer->kind) {
    case Answer::Kind::value:
        must(answer->text.size() == shape.digits && !shape.writes, "as many digits as the command has");
        must(answer->text.toUInt(nullptr, 16) == answer->value, "its digits");
        must(heard.answered == "\r\n" + answer->text + "\r\n", "both line ends");
        break;
    case Answer::Kind::text:
        must(shape.digits == 0 && answer->text.size() >= 4 && answer->text.size() <= 40, "a version");
        must(heard.answered == "\r\n" + answer->text + "\r\n", "both line ends");
        break;
    case Answer::Kind::accepted:
        must(shape.writes && heard.answered == "\r\n", "accepted");
        break;
    case Answer::Kind::unknownCommand:
        must(heard.answered == "03\r\n", "unknown");
        break;
    case Answer::Kind::outOfRange:
        must(heard.answered == "05\r\n", "out of range");
        break;
    }
    must(!exchangeText(exchange.request(), *answer).isEmpty(), "there is a text");
}

void exchangeWith(const Request &request, const Timing &timing, QByteArrayView pieces)
{
    Exchange exchange(request, timing);
    Instant now{};
    Heard heard;
    while (pieces.size() >= 2) {
        const Instant at = now + halfMillisecond * static_cast<unsigned char>(pieces[0]);
        const qsizetype size = std::min<qsizetype>(static_cast<unsigned char>(pieces[1]), pieces.size() - 2);
        passUntil(exchange, now, at, heard);
        exchange.received(pieces.sliced(2, size).toByteArray(), now);
        heard.arrived += pieces.sliced(2, size);
        pieces = pieces.sliced(2 + size);
    }
    passUntil(exchange, now, Instant::max(), heard);
    readRows(exchange, heard);
    must(heard.done, "it ends");
    must(heard.told == heard.arrived, "no byte is lost");
    const ExchangeResult &result = exchange.result();
    must(result.sent == heard.sendings, "every sending is counted");
    must(result.sent <= (shapeOf(request.command).writes ? 1 : 1 + timing.retries), "not sent too often");
    mustBeWellFormed(exchange, heard);
}

void parse(QByteArrayView typed)
{
    const auto request = parseRequest(typed);
    if (!request)
        return;
    must(parseRequest(request->text()) == request, "it is read as itself");
    must(request->text().size() >= typed.size(), "padded");
    must(!requestText(*request).isEmpty(), "there is a text");
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    if (size < 2)
        return 0;
    const QByteArrayView bytes(data, static_cast<qsizetype>(size));
    const auto commands = allCommands();
    const CommandShape &shape = commands[data[0] % commands.size()];
    const Request request{EscLineAddress{5}, shape.command, shape.writes ? shape.maximum : 0};
    parse(bytes);
    parse(bytes.sliced(2));
    exchangeWith(request, {.retries = data[1] % 4}, bytes.sliced(2));
    return 0;
}
