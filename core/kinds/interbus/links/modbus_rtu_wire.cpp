// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/links/modbus_rtu_wire.h"

#include "kinds/interbus/gateway/gateway_texts.h"
#include "kinds/interbus/gateway/rtu_frame.h"
#include "links/port_access.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"

namespace codewheel {
namespace {

using namespace std::chrono_literals;
using modbus_message::Pdu;
using ErrorKind = RegisterError::Kind;

constexpr int gapCharacters = 4;     // 3.5, MODBUS over Serial Line, 2.5.1.1
constexpr Instant shortestGap = 2ms; // 1.75 ms, there
constexpr int longestQuietWait = 5;  // times the time-out
constexpr int frameOverhead = 3;     // unit and checksum

ErrorKind goneBy(const Refusal &why)
{
    return why.id == RefusalId::portLost ? ErrorKind::unplugged : ErrorKind::closed;
}

// Whichever adapter is at the path: a gateway's is the one that its settings name.
KeptAdapter adapterAt(const QString &port)
{
    return KeptAdapter(portPath(port));
}

std::vector<PortInfo> noneIsKept()
{
    return {};
}

} // namespace

ModbusRtuWire::ModbusRtuWire(const GatewaySettings &settings)
    : m_settings(settings)
    , m_line(adapterAt(settings.serialPort), noneIsKept)
{}

Result<void> ModbusRtuWire::open()
{
    m_doubt = Doubt::none;
    m_answers.begin({});
    auto opened = m_line.open(m_settings.serial);
    m_lastByte = m_line.now();
    return opened;
}

// The time-out is that of the unit; what the characters need on the line comes on top of it.
tl::expected<Pdu, RegisterError> ModbusRtuWire::exchange(const Pdu &request)
{
    auto another = waitForGap();
    if (!another)
        return tl::unexpected(another.error());
    if (*another && m_doubt == Doubt::none)
        m_doubt = Doubt::another;
    if (auto quiet = m_doubt == Doubt::unanswered ? waitForQuiet() : Done(); !quiet)
        return tl::unexpected(quiet.error());
    const bool isCertain = std::exchange(m_doubt, Doubt::unanswered) == Doubt::none;
    Answer answer = ask(request);
    if (!answer || isCertain) {
        m_doubt = answer ? Doubt::none : Doubt::unanswered;
        return answer;
    }
    another = waitForGap();
    if (!another)
        return tl::unexpected(another.error());
    if (*another && **another != *answer) // whichever of the two is the right one
        return modbus_message::wrongAnswer(GatewayTexts::tr("another one follows it"));
    m_doubt = *another ? Doubt::another : Doubt::none; // a unit that always answers twice is one to live with
    return answer;
}

tl::expected<Pdu, RegisterError> ModbusRtuWire::ask(const Pdu &request)
{
    const auto timeOf = [this](std::size_t length) {
        return m_settings.serial.timeOf(static_cast<int>(length) + frameOverhead);
    };
    const Instant until = m_line.now() + timeOf(request.size()) + m_settings.timeOut;
    if (auto sent = send(request); !sent)
        return tl::unexpected(sent.error());
    return receive(until, until + timeOf(modbus_message::answerLength(request)));
}

RegisterPort::Done ModbusRtuWire::send(const Pdu &request)
{
    const ModbusBytes frame = rtuFrame(m_settings.unit, request);
    m_answers.begin(frame);
    m_otherUnit = -1;
    m_hasCome = false;
    const auto written = m_line.write(rtuByteArray(frame));
    if (written)
        return {};
    // A line that takes no more, or not all: nobody will answer that.
    const bool isFull = written.error().id == RefusalId::linkFailed;
    return tl::unexpected(RegisterError{isFull ? ErrorKind::noAnswer : goneBy(written.error()), 0,
                                        isFull ? QString() : refusalText(written.error())});
}

// An answer that has begun by the first time may come until the second.
ModbusRtuWire::Answer ModbusRtuWire::receive(Instant firstUntil, Instant until)
{
    for (;;) {
        if (auto answer = nextAnswer())
            return *std::move(answer);
        const Instant end = m_answers.isWithin() ? until : firstUntil;
        if (m_line.now() >= end)
            return tl::unexpected(whyNone());
        if (const auto came = takeBytes(end); !came)
            return tl::unexpected(came.error());
    }
}

// Frames of other units are passed over.
std::optional<Pdu> ModbusRtuWire::nextAnswer()
{
    while (auto frame = m_answers.next()) {
        if (frame->unit == m_settings.unit)
            return std::move(frame->pdu);
        m_otherUnit = frame->unit;
    }
    return std::nullopt;
}

RegisterError ModbusRtuWire::whyNone() const
{
    if (m_otherUnit >= 0)
        return {ErrorKind::wrongAnswer, 0,
                sentence(GatewayTexts::tr("it is of unit %1"), {QString::number(m_otherUnit)})};
    if (m_hasCome)
        return {ErrorKind::wrongAnswer, 0, GatewayTexts::tr("it is damaged or incomplete")};
    return {.kind = ErrorKind::noAnswer};
}

// Whether something came by then.
tl::expected<bool, RegisterError> ModbusRtuWire::takeBytes(Instant until)
{
    const auto bytes = m_line.read(until);
    if (!bytes)
        return tl::unexpected(RegisterError{goneBy(bytes.error()), 0, refusalText(bytes.error())});
    if (m_line.wasInterrupted())
        return tl::unexpected(RegisterError{.kind = ErrorKind::stopped});
    if (bytes->isEmpty())
        return false;
    m_lastByte = m_line.now();
    m_hasCome = true;
    m_answers.take(rtuOctets(*bytes));
    return true;
}

// An answer that comes in it, if any.
tl::expected<std::optional<Pdu>, RegisterError> ModbusRtuWire::waitForGap()
{
    const Instant end = m_line.now() + longestQuietWait * m_settings.timeOut;
    const Instant gap = std::max(m_settings.serial.timeOf(gapCharacters), shortestGap);
    std::optional<Pdu> another;
    for (;;) {
        const auto came = takeBytes(m_lastByte + gap);
        if (!came)
            return tl::unexpected(came.error());
        while (auto answer = nextAnswer())
            another = std::move(answer);
        if (!*came)
            return another;
        if (m_line.now() >= end)
            return modbus_message::wrongAnswer(
                GatewayTexts::tr("something on the line does not stop sending"));
    }
}

RegisterPort::Done ModbusRtuWire::waitForQuiet()
{
    const Instant end = m_line.now() + longestQuietWait * m_settings.timeOut;
    for (;;) {
        const auto came = takeBytes(m_line.now() + m_settings.timeOut);
        if (!came)
            return tl::unexpected(came.error());
        if (!*came)
            return {};
        if (m_line.now() >= end)
            return modbus_message::wrongAnswer(
                GatewayTexts::tr("something on the line does not stop sending"));
    }
}

} // namespace codewheel
