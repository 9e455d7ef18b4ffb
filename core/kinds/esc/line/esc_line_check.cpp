// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/line/esc_line_check.h"

#include "kinds/esc/line/exchange_over_link.h"
#include "vocabulary/hex.h"
#include "vocabulary/sentence.h"

#include <QLocale>

#include <utility>

namespace codewheel {
namespace {

// What is missing is the port itself; any other refusal is about opening it.
bool isAboutPort(RefusalCode id)
{
    return id == RefusalId::portNotFound || id == RefusalId::portOfOther;
}

QString inMilliseconds(Instant time)
{
    constexpr double microseconds = 1'000; // a millisecond
    return QLocale().toString(static_cast<double>(time.count()) / microseconds, 'f', 1);
}

} // namespace

EscLineCheck::EscLineCheck(ByteLink &link, EscLineSettings settings, std::vector<EscLineAddress> addresses)
    : LinkCheck(link, {{EscLineStep::found}, {EscLineStep::opened}, {EscLineStep::quiet}})
    , m_settings(std::move(settings))
{
    if (addresses.empty())
        addresses.push_back(EscLineAddress::master());
    for (const EscLineAddress address : addresses)
        addStep(EscLineStep::encoder, address);
}

QString EscLineCheck::stepText(EscLineStep step, EscLineAddress address)
{
    switch (step) {
    case EscLineStep::found:
        return tr("Serial port");
    case EscLineStep::opened:
        return tr("Opening");
    case EscLineStep::quiet:
        return tr("Silence before asking");
    case EscLineStep::encoder:
        break;
    }
    return address.isMaster() ? tr("Any encoder") : sentence(tr("Encoder %1"), {address.shown()});
}

EscLineFinding EscLineCheck::found(EscLineStep step, EscLineAddress address)
{
    switch (step) {
    case EscLineStep::found:
        return find();
    case EscLineStep::opened:
        return open();
    case EscLineStep::quiet:
        return listen();
    case EscLineStep::encoder:
        break;
    }
    return ask(address);
}

// A link looks for its port and opens it in one call.
EscLineFinding EscLineCheck::find()
{
    m_opened = link().open(m_settings.serial);
    if (!m_opened && isAboutPort(m_opened.error().id))
        return refused(m_opened.error());
    return told(CheckOutcome::passed, sentence(tr("The port %1 is there."), {link().name()}));
}

EscLineFinding EscLineCheck::open()
{
    if (!m_opened)
        return refused(m_opened.error());
    const QString opened = sentence(tr("Opened at %1 Bd."), {QString::number(m_settings.serial.baudRate)});
    if (link().lowLatency() != LowLatency::refused)
        return told(CheckOutcome::passed, opened);
    return told(CheckOutcome::passed, opened + u' ' +
                                          tr("The adapter does not grant low latency: it may collect bytes "
                                             "for up to 16 ms, which halves the rate of positions."));
}

EscLineFinding EscLineCheck::listen()
{
    QByteArray heard;
    const Instant until = link().now() + listens;
    while (link().now() < until && !isStopped()) {
        const auto bytes = link().read(until);
        if (!bytes)
            return refused(bytes.error());
        heard += *bytes;
    }
    if (heard.isEmpty())
        return told(CheckOutcome::passed,
                    sentence(tr("Nothing came within %1 ms."),
                             {QLocale().toString(static_cast<int>(listens / std::chrono::milliseconds(1)))}));
    endHere();
    return told(CheckOutcome::failed,
                tr("%n bytes came before anything was asked: another master works on this line, or something "
                   "sends by itself. Nothing was sent.",
                   nullptr, static_cast<int>(heard.size())));
}

QString EscLineCheck::silenceText(int strayBytes, bool isEchoed)
{
    if (strayBytes > 0)
        return tr("%n bytes came, but no answer of an encoder. Check baud rate and format, and whether two "
                  "encoders answer at once.",
                  nullptr, strayBytes);
    if (isEchoed)
        return tr("Only the request came back: the adapter hears itself, and no encoder answers. Check "
                  "address, wires and supply.");
    return tr("Nothing came. Check address, baud rate, wires (A and B may be swapped) and supply; an RS-422 "
              "encoder also needs ST (pin 7) at +UB.");
}

EscLineFinding EscLineCheck::ask(EscLineAddress address)
{
    esc::Timing timing = m_settings.timing;
    timing.character = m_settings.serial.timeOf(1);
    const auto exchanged = exchangeOver(link(), {address, esc::Command::position}, timing, isStopped());
    if (!exchanged)
        return refused(exchanged.error());
    if (isStopped())
        return stopped();
    const esc::ExchangeResult &result = exchanged->result;
    const auto &answer = result.answer;
    if (!answer)
        return told(CheckOutcome::failed,
                    silenceText(result.garbageBytes + result.lateBytes, result.isEchoed));
    if (answer->kind != esc::Answer::Kind::value)
        return told(CheckOutcome::failed, sentence(tr("It answers, but not with a position: %1."),
                                                   {QString::fromLatin1(answer->text.simplified())}));
    return told(CheckOutcome::passed, sentence(tr("It answers after %1 ms: position %2 (%3h)."),
                                               {inMilliseconds(result.answerTime),
                                                QLocale().toString(answer->value), hexWord(answer->value)}));
}

} // namespace codewheel
