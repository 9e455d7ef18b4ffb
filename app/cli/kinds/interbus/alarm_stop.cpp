// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/kinds/interbus/alarm_stop.h"

#include "cli/call/stop_signals.h"
#include "cli/call/subcommand.h"
#include "cli/kinds/interbus/gateway_access.h"
#include "cli/kinds/interbus/sent_zeros_text.h"
#include "kinds/interbus/gateway/gateway_refusals.h"
#include "kinds/interbus/ring/ring_messages.h"
#include "vocabulary/refusal_text.h"

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace codewheel {
namespace {

using namespace std::chrono_literals;
using std::chrono::steady_clock;

constexpr auto betweenTries = 1s;
constexpr auto betweenLooks = 10ms;
constexpr auto untilLate = 1s;
constexpr auto whetherTheyStand = 500ms; // zeros that have arrived

// When zeros are late, and when nobody tries any longer.
class Patience
{
public:
    explicit Patience(std::chrono::seconds longest)
        : m_longest(longest)
    {}

    bool isLate() const { return steady_clock::now() - m_begun >= untilLate; }
    bool goesOn() { return left() > 0s && !m_stop.came(); }
    bool isStopped() { return m_stop.came(); }
    steady_clock::duration left() const { return m_begun + m_longest - steady_clock::now(); }
    // It may have ended early, by Ctrl+C, or late, by an answer that was waited for.
    std::chrono::seconds had() const
    {
        return std::clamp(std::chrono::ceil<std::chrono::seconds>(steady_clock::now() - m_begun),
                          std::chrono::seconds(1), m_longest);
    }

private:
    const std::chrono::seconds m_longest;
    const steady_clock::time_point m_begun = steady_clock::now();
    StopSignals m_stop;
};

// On standard error, each sentence once.
class ZerosSayer
{
public:
    ZerosSayer(const Call &call, const GatewayAccess &access, bool namesIt)
        : m_call(call)
        , m_access(access)
        , m_whose(namesIt ? access.name() + QStringLiteral(": ") : QString())
    {}

    void say(const QString &text)
    {
        if (text.isEmpty() || m_said.contains(text))
            return;
        m_said << text;
        m_call.terminal.complain(m_whose + text);
    }
    void sayHowTheyStand() { say(unfinishedZerosText(m_access.sentZeros())); }

private:
    const Call &m_call;
    const GatewayAccess &m_access;
    const QString m_whose;
    QStringList m_said;
};

// Says after a second how they stand, though this thread may be held by a gateway that is mute. Nobody else
// may use the sayer while it lives.
class LateZeros
{
public:
    explicit LateZeros(ZerosSayer &sayer)
        : m_saysSo([&sayer](const std::stop_token &stop) {
            std::mutex mutex;
            std::unique_lock lock(mutex);
            std::condition_variable_any over;
            over.wait_for(lock, stop, untilLate, [] { return false; });
            if (!stop.stop_requested())
                sayer.sayHowTheyStand();
        })
    {}

private:
    std::jthread m_saysSo;
};

// The gateway may hear what it does not answer.
Checked<void> sendUnheardAndOpen(GatewayAccess &access)
{
    access.ring().sendZerosUnheard(); // before anything is asked
    return access.open();
}

Checked<void> openForZeros(GatewayAccess &access, ZerosSayer &sayer, Patience &patience)
{
    auto opened = [&] {
        const LateZeros late(sayer);
        return access.sentZeros().sentAt ? access.open() : sendUnheardAndOpen(access); // of several rings
    }();
    const auto isWorthTrying = [&] { return !opened && opened.error().exit != ExitCode::badInput; };
    while (isWorthTrying() && patience.goesOn()) {
        sayer.sayHowTheyStand();
        std::this_thread::sleep_for(std::min<steady_clock::duration>(betweenTries, patience.left()));
        opened = sendUnheardAndOpen(access);
    }
    return opened;
}

bool isEndOfZeros(const Message &message)
{
    return message.id == RingMessageId::zerosReadBack || message.id == RingMessageId::zerosSent ||
           message.id == RingMessageId::zerosOverwritten || message.id == RingMessageId::zerosBeforeRing;
}

// Zeros that somebody else has overwritten, or that no ring carries on, have not stopped anything.
bool isFailureOfZeros(const Message &message)
{
    return message.id == RingMessageId::zerosOverwritten || message.id == RingMessageId::zerosBeforeRing;
}

bool isHindrance(const Message &message)
{
    return message.refusal && message.refusal->id != GatewayRefusalId::outNotReadBack; // zerosSent says so
}

// What the ring tells about zeros while they are on their way.
class ZerosOnTheirWay
{
public:
    ZerosOnTheirWay(GatewayAccess &access, ZerosSayer &sayer)
    {
        QObject::connect(&access.ring(), &RingSession::messaged, &m_scope,
                         [this, &sayer](const Message &one) {
                             take(one);
                             if (!isHindrance(one))
                                 return;
                             sayer.say(complaintAtGateway(*one.refusal).text);
                             sayer.sayHowTheyStand();
                         });
    }

    bool isOver() const { return std::ranges::any_of(m_messages, isEndOfZeros); }
    const std::vector<Message> &messages() const { return m_messages; }

private:
    // A hindrance comes again with each try. Zeros that were overwritten are not there.
    void take(const Message &message)
    {
        const auto isSame = [&](const Message &one) { return one.refusal == message.refusal; };
        const bool isNews = isHindrance(message) && std::ranges::none_of(m_messages, isSame);
        if (message.id == RingMessageId::zerosOverwritten)
            std::erase_if(m_messages,
                          [](const Message &one) { return one.id == RingMessageId::zerosReadBack; });
        if (isNews || isEndOfZeros(message))
            m_messages.push_back(message);
    }

    QObject m_scope;
    std::vector<Message> m_messages;
};

void lookFor(RingSession &ring, steady_clock::duration time, Patience &patience)
{
    for (const auto end = steady_clock::now() + time; steady_clock::now() < end && !patience.isStopped();) {
        std::this_thread::sleep_for(betweenLooks);
        ring.pump();
    }
}

void sendZeros(RingSession &ring, const ZerosOnTheirWay &zeros, ZerosSayer &sayer, Patience &patience)
{
    ring.alarmStop();
    ring.startThread({});
    while (!zeros.isOver() && patience.goesOn()) {
        std::this_thread::sleep_for(betweenLooks);
        ring.pump();
        if (patience.isLate() && !zeros.isOver())
            sayer.sayHowTheyStand();
    }
    if (zeros.isOver())
        lookFor(ring, whetherTheyStand, patience);
}

// Each at the time when it was so, the first of all: the ring tells it later.
std::vector<Message> inTheirTime(std::vector<Message> messages, const GatewayAccess &access)
{
    const SentZeros zeros = access.sentZeros();
    for (Message &message : messages) {
        if (message.id == RingMessageId::zerosReadBack)
            message.at = zeros.readBackAt.value_or(message.at);
        if (message.id == RingMessageId::zerosSent)
            message.at = zeros.acknowledgedAt.value_or(message.at);
    }
    if (zeros.sentAt)
        messages.push_back(
            {.at = *zeros.sentAt, .place = access.ring().placeOf(NodeId()), .id = RingMessageId::zerosAsked});
    std::ranges::stable_sort(messages, {}, &Message::at);
    return messages;
}

std::optional<Complaint> complaintAboutFailure(const std::vector<Message> &messages)
{
    const auto failed = std::ranges::find_if(messages, isFailureOfZeros);
    if (failed == messages.end())
        return std::nullopt;
    return Complaint{ExitCode::refused, messageKey(failed->id), messageText(*failed)};
}

GatewayStop accountOf(const GatewayAccess &access, const std::vector<Message> &told)
{
    const SentZeros zeros = access.sentZeros();
    const bool areOverwritten = std::ranges::count(told, RingMessageId::zerosOverwritten, &Message::id) > 0;
    GatewayStop stop{.messages = inTheirTime(told, access),
                     .text = sentZerosText(access, zeros, areOverwritten),
                     .json = sentZerosJson(access, zeros, areOverwritten),
                     .complaint = complaintAboutFailure(told)};
    std::ranges::copy_if(stop.messages, std::back_inserter(stop.unsaid), [](const Message &message) {
        return !message.refusal && !isFailureOfZeros(message);
    });
    return stop;
}

Checked<GatewayStop> notOpened(const GatewayAccess &access, const Complaint &why, const Patience &patience)
{
    if (why.exit == ExitCode::badInput)
        return tl::unexpected(why);
    GatewayStop stop = accountOf(access, {});
    stop.complaint = why;
    stop.complaint->text += u' ' + missedZeros(access.sentZeros(), patience.had()).text;
    return stop;
}

} // namespace

Checked<GatewayStop> alarmStopBehindGateway(const Call &call, GatewayAccess &access,
                                            std::chrono::seconds patience, bool isOneOfSeveral)
{
    Patience lasts(patience);
    ZerosSayer sayer(call, access, isOneOfSeveral);
    if (const auto opened = openForZeros(access, sayer, lasts); !opened)
        return notOpened(access, opened.error(), lasts);
    const ZerosOnTheirWay zeros(access, sayer);
    sendZeros(access.ring(), zeros, sayer, lasts);
    GatewayStop stop = accountOf(access, zeros.messages());
    if (!zeros.isOver())
        stop.complaint = missedZeros(access.sentZeros(), lasts.had());
    return stop;
}

} // namespace codewheel
