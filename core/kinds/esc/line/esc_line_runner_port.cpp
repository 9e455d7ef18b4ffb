// SPDX-License-Identifier: GPL-3.0-or-later
// A port that goes away and comes back.
#include "kinds/esc/line/esc_line_runner_private.h"
#include "kinds/esc/line/port_argument.h"
#include "kinds/esc/protocol/esc_messages.h"

#include <algorithm>

namespace codewheel {
namespace {

constexpr std::chrono::seconds betweenTries{1}; // of opening a port that is gone

} // namespace

void EscLineRunner::Private::portIsGone(const Refusal &why)
{
    state.connected = false;
    state.whyLost = why;
    reopenAt = link.now() + betweenTries;
    notBack.reset();
    if (why.id == RefusalId::portLost)
        tell({.severity = Severity::fault, .id = EscMessageId::portLost, .arguments = {portArgument(link)}});
    else
        tell({.severity = Severity::fault, .refusal = why});
    stopJobs(why);
    state.operate = false;
    tearOff();
    dropTyped();
    endScan(true);
    for (std::size_t i = 0; i < devices.size(); ++i)
        if (driver(i))
            driver(i)->lineLost(link.now());
    forgetTurns();
    link.close();
    publish();
}

// A write that was sent may have been carried out, though nobody will see its answer.
void EscLineRunner::Private::tearOff()
{
    if (!underWay)
        return;
    UnderWay torn = std::move(*underWay);
    underWay.reset();
    tellRows(torn.exchange.takeRows());
    const esc::ExchangeResult &result = torn.exchange.result();
    if (torn.asker == Asker::terminal) {
        typedEnded(torn.exchange.request(), result);
    } else if (torn.asker == Asker::device && driver(torn.device) && result.sent > 0) {
        driver(torn.device)->observe(torn.exchange.request(), result, link.now());
        collect(torn.device);
    }
}

void EscLineRunner::Private::waitForPort(Instant until)
{
    carryOutCommands();
    if (link.now() < reopenAt)
        link.wait(std::min(until, reopenAt));
    else
        tryToReopen();
}

void EscLineRunner::Private::tryToReopen()
{
    reopenAt = link.now() + betweenTries;
    if (const auto opened = link.open(settings); !opened) {
        portIsNotBack(opened.error());
        return;
    }
    baudRate = settings.baudRate;
    state.connected = true;
    state.whyLost.reset();
    state.otherAdapter = false;
    state.operate = false;
    tell({.id = EscMessageId::portBack, .arguments = {portArgument(link)}});
    takeLowLatency();
    publish();
}

// That it is missing has been reported. Anything else in the way is reported once.
void EscLineRunner::Private::portIsNotBack(const Refusal &why)
{
    const bool isOther = why.id == RefusalId::portOfOther;
    const bool isNew = notBack != why;
    notBack = why;
    if (isNew && why.id != RefusalId::portNotFound)
        tell({.severity = Severity::attention, .refusal = why});
    if (isNew && isOther)
        tellEvent(OtherAdapter{why});
    if (std::exchange(state.otherAdapter, isOther) != isOther)
        publish();
}

void EscLineRunner::Private::takeLowLatency()
{
    state.lowLatency = link.lowLatency();
    if (state.lowLatency == LowLatency::refused && !std::exchange(latencyTold, true))
        tell({.severity = Severity::attention,
              .id = EscMessageId::lowLatencyRefused,
              .arguments = {portArgument(link)}});
}

} // namespace codewheel
