// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/line/esc_line_permission.h"
#include "kinds/esc/line/esc_line_runner_private.h"
#include "kinds/esc/line/port_argument.h"
#include "kinds/esc/protocol/esc_messages.h"

#include <algorithm>

namespace codewheel {

void EscLineRunner::Private::carryOutCommands()
{
    bool isOther = false;
    while (auto next = mail.nextCommand()) {
        std::visit([this](auto &c) { carryOut(c); }, *next);
        isOther = true;
    }
    if (isOther)
        publish();
}

Result<void> EscLineRunner::Private::mayStart(std::size_t device, const Job &job) const
{
    const QString place = driver(device)->address().node().toString();
    if (auto allowed = codewheel::mayStart(state, job, place, portArgument(link)); !allowed)
        return allowed;
    if (driver(device)->busy())
        return refuse(RefusalKind::busy, RefusalId::jobRunning, {place});
    return {};
}

void EscLineRunner::Private::carryOut(line_command::StartJob &c)
{
    if (!driver(c.device))
        return;
    auto taken = mayStart(c.device, c.job);
    if (taken)
        taken = driver(c.device)->begin(c.id, c.job, c.pace, link.now());
    if (!taken)
        tellEvent(Event(notTaken(c.id, taken.error(), driver(c.device)->reading().state)), c.device);
    collect(c.device);
}

void EscLineRunner::Private::carryOut(line_command::Proceed &c)
{
    if (driver(c.device))
        driver(c.device)->proceed();
}

// The job may have ended while the command was on its way.
void EscLineRunner::Private::carryOut(line_command::Cancel &c)
{
    if (!driver(c.device) || !driver(c.device)->busy())
        return;
    driver(c.device)->cancel(c.how, link.now());
    collect(c.device);
}

void EscLineRunner::Private::carryOut(line_command::SetKnown &c)
{
    if (driver(c.device))
        driver(c.device)->setKnown(c.known);
}

void EscLineRunner::Private::carryOut(line_command::AddDevice &c)
{
    c.driver->setLineBaudRate(settings.baudRate);
    devices.push_back({.driver = std::move(c.driver), .name = std::move(c.name), .counter = {}, .turn = 0});
    tellTaken();
}

void EscLineRunner::Private::carryOut(line_command::RemoveDevice &c)
{
    if (!driver(c.device))
        return;
    if (driver(c.device)->busy())
        driver(c.device)->stop({RefusalKind::stopped, RefusalId::busStopped, {}}, link.now());
    collect(c.device);
    devices[c.device].driver.reset();
    tellTaken();
}

void EscLineRunner::Private::carryOut(line_command::SetRunning &c)
{
    if (c.on == state.running)
        return;
    state.running = c.on;
    if (!state.running)
        stopJobs({RefusalKind::stopped, RefusalId::busStopped, {}});
    tell({.id = c.on ? MessageId::busStarted : MessageId::busStopped});
}

void EscLineRunner::Private::carryOut(line_command::SetOperate &c)
{
    if (c.on == state.operate)
        return;
    const auto busy = std::ranges::find_if(
        devices, [](const Device &device) { return device.driver && device.driver->busy(); });
    if (busy != devices.end()) {
        const auto place = placeOnLine(busy->driver->address());
        tell({.severity = Severity::attention,
              .refusal = Refusal{RefusalKind::busy, RefusalId::jobRunning, {place.toString()}}});
        return;
    }
    state.operate = c.on;
    tell({.id = c.on ? MessageId::operateOn : MessageId::watchOn});
}

// A serial encoder's outputs move nothing: what has to stop is what is still to be sent.
void EscLineRunner::Private::carryOut(line_command::AlarmStop &)
{
    dropTyped();
    endScan(true);
    stopJobs({RefusalKind::stopped, RefusalId::alarmStop, {}});
}

void EscLineRunner::Private::carryOut(line_command::Send &c)
{
    if (const auto allowed = maySend(state, c.request, portArgument(link)); allowed) {
        typed.push_back(c.request);
    } else {
        tell({.severity = Severity::attention, .refusal = allowed.error()});
        tellEvent(TypedAnswered{c.request, {}, allowed.error()});
    }
}

void EscLineRunner::Private::carryOut(line_command::Scan &c)
{
    endScan(true);
    if (state.connected)
        scan.emplace(std::move(c.wish));
}

void EscLineRunner::Private::carryOut(line_command::TakeOtherAdapter &)
{
    if (state.connected)
        return;
    link.takeOtherAdapter();
    reopenAt = link.now();
}

void EscLineRunner::Private::carryOut(line_command::SetFractionBits &c)
{
    for (const Device &device : devices)
        if (device.driver)
            device.driver->setFractionBits(c.bits);
}

void EscLineRunner::Private::carryOut(line_command::SetSwapsWarningBytes &c)
{
    if (driver(c.device))
        driver(c.device)->setSwapsWarningBytes(c.on);
}

void EscLineRunner::Private::carryOut(line_command::CancelScan &)
{
    endScan(true);
}

void EscLineRunner::Private::endScan(bool cancelled)
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
void EscLineRunner::Private::tellTaken()
{
    for (const Device &device : devices) {
        if (!device.driver)
            continue;
        std::map<EscLineAddress, QString> others;
        for (const Device &other : devices)
            if (other.driver && &other != &device)
                others.emplace(other.driver->address(), other.name);
        device.driver->setTaken(others);
    }
}

// Nothing of it was sent.
void EscLineRunner::Private::dropTyped()
{
    for (const esc::Request &request : std::exchange(typed, {}))
        tellEvent(TypedAnswered{request, {}});
}

void EscLineRunner::Private::stopJobs(const Refusal &why)
{
    for (std::size_t i = 0; i < devices.size(); ++i) {
        if (!driver(i) || !driver(i)->busy())
            continue;
        driver(i)->stop(why, link.now());
        collect(i);
    }
}

} // namespace codewheel
