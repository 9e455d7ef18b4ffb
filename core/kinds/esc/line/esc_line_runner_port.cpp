// SPDX-License-Identifier: GPL-3.0-or-later
// A port that goes away and comes back.
#include "kinds/esc/line/esc_line_runner_private.h"
#include "kinds/esc/line/port_argument.h"
#include "kinds/esc/protocol/esc_messages.h"

namespace codewheel {
void EscLineWork::tellGone(const Refusal &why)
{
    if (why.id == RefusalId::portLost)
        tell({.severity = Severity::fault, .id = EscMessageId::portLost, .arguments = {portArgument(link)}});
    else
        AskingWork::tellGone(why);
}

// A write that was sent may have been carried out, though nobody will see its answer.
void EscLineWork::leaveOff()
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

void EscLineWork::linkIsBack()
{
    baudRate = settings.baudRate;
    state.otherAdapter = false;
    tell({.id = EscMessageId::portBack, .arguments = {portArgument(link)}});
    linkIsOpen();
}

// That it is missing has been reported.
void EscLineWork::tellNotBack(const Refusal &why, bool isNew)
{
    const bool isOther = why.id == RefusalId::portOfOther;
    if (isNew && why.id != RefusalId::portNotFound)
        tell({.severity = Severity::attention, .refusal = why});
    if (isNew && isOther)
        tellEvent(OtherAdapter{why});
    if (std::exchange(state.otherAdapter, isOther) != isOther)
        publish();
}

void EscLineWork::linkIsOpen()
{
    state.lowLatency = link.lowLatency();
    if (state.lowLatency == LowLatency::refused && !std::exchange(latencyTold, true))
        tell({.severity = Severity::attention,
              .id = EscMessageId::lowLatencyRefused,
              .arguments = {portArgument(link)}});
}

} // namespace codewheel
