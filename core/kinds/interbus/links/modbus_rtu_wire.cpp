// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/links/modbus_rtu_wire.h"

#include "kinds/interbus/gateway/rtu_frame.h"
#include "links/port_access.h"
#include "vocabulary/refusal_text.h"

#include <algorithm>
#include <utility>

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

bool isOfSameForm(const Pdu &one, const Pdu &other)
{
    return one.front() == other.front() &&
           modbus_message::answerLength(one) == modbus_message::answerLength(other);
}

} // namespace

ModbusRtuWire::ModbusRtuWire(const GatewaySettings &settings)
    : m_settings(settings)
    , m_line(adapterAt(settings.serialPort), noneIsKept)
{}

Result<void> ModbusRtuWire::open()
{
    m_doubt = Doubt::none;
    m_unanswered.clear();
    m_mayHaveComeLate = false;
    m_comesLate = false;
    m_answers.begin({});
    auto opened = m_line.open(m_settings.serial);
    m_lastByte = m_line.now();
    return opened;
}

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
    Answer answer = isCertain ? ask(request) : askWhileInDoubt(request);
    if (isCertain && answer)
        m_doubt = Doubt::none;
    learn(request, answer, isCertain);
    return answer;
}

// An answer may be followed by another one; then nobody knows which of the two is the right one.
ModbusRtuWire::Answer ModbusRtuWire::askWhileInDoubt(const Pdu &request)
{
    Answer answer = ask(request);
    if (!answer)
        return answer;
    const auto another = waitForGap();
    if (!another)
        return tl::unexpected(another.error());
    if (*another && **another != *answer)
        return modbus_message::wrongAnswer(WrongAnswer::another);
    m_doubt = *another ? Doubt::another : Doubt::none; // a unit that always answers twice is one to live with
    return answer;
}

// An answer in doubt with silence behind it was that to the request before. One of another form leaves its
// request unanswered, too.
void ModbusRtuWire::learn(const Pdu &request, Answer &answer, bool isCertain)
{
    const bool isAnswered = answer && modbus_message::mayAnswer(request, *answer);
    if (isAnswered && isCertain) {
        m_unanswered.clear();
        m_comesLate = false;
    }
    const bool wasInDoubt = std::exchange(m_mayHaveComeLate, isAnswered && !m_unanswered.empty());
    if (isAnswered || (!answer && answer.error().kind != ErrorKind::noAnswer))
        return;
    if (!answer) {
        m_comesLate = m_comesLate || wasInDoubt;
        answer.error().isLate = m_comesLate;
    }
    if (std::ranges::none_of(m_unanswered, [&](const Pdu &one) { return isOfSameForm(one, request); }))
        m_unanswered.push_back(request);
}

// The time-out is that of the unit; what the characters need on the line comes on top of it.
tl::expected<Pdu, RegisterError> ModbusRtuWire::ask(const Pdu &request)
{
    const auto timeOf = [this](std::size_t length) {
        return m_settings.serial.timeOf(static_cast<int>(length) + frameOverhead);
    };
    const Instant until = m_line.now() + timeOf(request.size()) + m_settings.timeOut;
    if (auto sent = send(request); !sent)
        return tl::unexpected(sent.error());
    return receive(request, until, until + timeOf(modbus_message::answerLength(request)));
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
ModbusRtuWire::Answer ModbusRtuWire::receive(const Pdu &request, Instant firstUntil, Instant until)
{
    for (;;) {
        if (auto answer = nextAnswer()) {
            if (modbus_message::mayAnswer(request, *answer) || !isOfEarlier(*answer))
                return *std::move(answer);
            m_comesLate = true;
            m_hasCome = false;
            continue;
        }
        const Instant end = m_answers.isWithin() ? until : firstUntil;
        if (m_line.now() >= end)
            return tl::unexpected(whyNone());
        if (const auto came = takeBytes(end); !came)
            return tl::unexpected(came.error());
    }
}

bool ModbusRtuWire::isOfEarlier(const Pdu &answer) const
{
    return std::ranges::any_of(
        m_unanswered, [&](const Pdu &request) { return modbus_message::mayAnswer(request, answer); });
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
        return {ErrorKind::wrongAnswer, 0, wrongAnswerKey(WrongAnswer::unit, {m_otherUnit})};
    if (m_hasCome)
        return {ErrorKind::wrongAnswer, 0, wrongAnswerKey(WrongAnswer::damaged)};
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
        while (auto answer = nextAnswer()) {
            m_comesLate = m_comesLate || isOfEarlier(*answer);
            another = std::move(answer);
        }
        if (!*came)
            return another;
        if (m_line.now() >= end)
            return modbus_message::wrongAnswer(WrongAnswer::noPause);
    }
}

RegisterPort::Done ModbusRtuWire::waitForQuiet()
{
    const Instant end = m_line.now() + longestQuietWait * m_settings.timeOut;
    for (;;) {
        const auto came = takeBytes(m_line.now() + m_settings.timeOut);
        if (!came)
            return tl::unexpected(came.error());
        while (const auto late = nextAnswer())
            m_comesLate = m_comesLate || isOfEarlier(*late);
        if (!*came)
            return {};
        if (m_line.now() >= end)
            return modbus_message::wrongAnswer(WrongAnswer::noPause);
    }
}

} // namespace codewheel
