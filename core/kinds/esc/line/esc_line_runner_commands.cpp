// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/line/esc_line_permission.h"
#include "kinds/esc/line/esc_line_runner_private.h"
#include "kinds/esc/line/port_argument.h"
#include "kinds/esc/protocol/esc_messages.h"

namespace codewheel {

void EscLineWork::carryOutNext(EscLineCommand &command)
{
    std::visit([this](auto &c) { carryOut(c); }, command);
}

Result<void> EscLineWork::mayStart(const RequestDriver &driver, const Job &job) const
{
    return codewheel::mayStart(state, job, placeOf(driver).toString(), portArgument(link));
}

void EscLineWork::carryOut(line_command::AddDevice &c)
{
    c.driver->setLineBaudRate(settings.baudRate);
    drivers.push_back(std::move(c.driver));
    devices.push_back({.name = std::move(c.name), .counter = {}});
    tellTaken();
}

void EscLineWork::carryOut(line_command::RemoveDevice &c)
{
    AskingWork::carryOut(c);
    tellTaken();
}

void EscLineWork::carryOut(line_command::Send &c)
{
    if (const auto allowed = maySend(state, c.request, portArgument(link)); allowed) {
        typed.push_back(c.request);
    } else {
        tell({.severity = Severity::attention, .refusal = allowed.error()});
        tellEvent(TypedAnswered{c.request, {}, allowed.error()});
    }
}

void EscLineWork::carryOut(line_command::Scan &c)
{
    endScan(true);
    if (state.connected)
        scan.emplace(std::move(c.wish));
}

void EscLineWork::carryOut(line_command::TakeOtherAdapter &)
{
    if (state.connected)
        return;
    link.takeOtherAdapter();
    reopenAt = link.now();
}

void EscLineWork::carryOut(line_command::SetFractionBits &c)
{
    for (const auto &its : drivers)
        if (its)
            its->setFractionBits(c.bits);
}

void EscLineWork::carryOut(line_command::SetSwapsWarningBytes &c)
{
    if (driver(c.device))
        driver(c.device)->setSwapsWarningBytes(c.on);
}

void EscLineWork::endScan(bool cancelled)
{
    if (!scan)
        return;
    tellEvent(ScanEnded{scan->found(), scan->requests(), cancelled});
    tell({.id = EscMessageId::encodersFound,
          .arguments = {static_cast<std::int64_t>(scan->found().size()),
                        static_cast<std::int64_t>(scan->requests())}});
    scan.reset();
    publish();
}

// Each driver knows the addresses of the others, so that no job moves its device to one of them.
void EscLineWork::tellTaken()
{
    for (const auto &its : drivers) {
        if (!its)
            continue;
        std::map<EscLineAddress, QString> others;
        for (std::size_t other = 0; other < drivers.size(); ++other)
            if (drivers[other] && drivers[other] != its)
                others.emplace(drivers[other]->address(), devices[other].name);
        its->setTaken(others);
    }
}

// Nothing of it was sent.
void EscLineWork::dropTyped()
{
    for (const esc::Request &request : std::exchange(typed, {}))
        tellEvent(TypedAnswered{request, {}});
}

} // namespace codewheel
