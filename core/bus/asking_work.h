// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/asked_command.h"
#include "bus/asked_snapshot.h"
#include "bus/bus_work.h"
#include "bus/wall_time.h"
#include "vocabulary/message.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace codewheel {

// What is done on a bus whose encoders are asked, as far as all kinds do the same: commands, the jobs of the
// drivers, and a link that goes away and comes back.
//
// When the link is gone that is reported once, the jobs end, and it is opened again each second, in Watch.
template <class Command, class BusEvent, class Snapshot, class Link, class Driver>
struct AskingWork : BusWork
{
    using Mail = BusMail<Command, BusEvent, Snapshot>;
    using State = typename Snapshot::State;
    using Shown = typename Snapshot::Device;

    static constexpr std::chrono::seconds betweenTries{1}; // of opening a link that is gone

    AskingWork(Link &usedLink, Mail &usedMail)
        : link(usedLink)
        , mail(usedMail)
    {
        state.connected = true;
    }

    Result<void> open(const std::stop_token &stop) override
    {
        auto opened = openUnlessStopped(stop, [this] { return openLink(); });
        tellEvent(LinkOpened{opened});
        if (opened)
            linkIsOpen();
        return opened;
    }
    void turn(Instant until) override
    {
        while (link.now() < until) {
            if (state.connected)
                step(until);
            else
                waitForLink(until);
        }
    }
    void slept(std::chrono::milliseconds duration) override
    {
        awakeSince = link.now();
        carryOutCommands(); // posted before
        endAll({RefusalKind::stopped, RefusalId::computerSlept, {}});
        state.operate = false;
        tap.interrupt();
        tellEvent(Slept{duration});
        publish();
    }
    void close() override
    {
        carryOutCommands();
        endAll({RefusalKind::stopped, RefusalId::busStopped, {}});
        sendLast();
        leaveOff();
        publish();
        link.close();
    }
    Instant now() const override { return link.now(); }
    void interrupt() override { link.interrupt(); }

    // By the kind of bus.
    virtual Result<void> openLink() = 0;
    virtual Result<void> reopenLink() { return openLink(); }
    virtual void linkIsOpen() {}
    virtual void tellGone(const Refusal &why) { tell({.severity = Severity::fault, .refusal = why}); }
    virtual void tellNotBack(const Refusal &why, bool isNew) = 0;
    virtual void linkIsBack() = 0;
    virtual void forget() {}                         // what was heard over a link that is gone
    virtual void step(Instant until) = 0;            // while the link is there
    virtual void carryOutNext(Command &command) = 0; // by carryOut()
    virtual Result<void> mayStart(const Driver &driver, const Job &job) const = 0;
    virtual Place placeOf(const Driver &driver) const = 0; // whatever the bus
    virtual void settleDevice(std::size_t /*device*/) {}   // its driver may want something else now
    virtual void jobStopped(std::size_t /*device*/) {}
    virtual void dropTyped() = 0; // what was not sent yet
    virtual void endScan(bool cancelled) = 0;
    virtual void leaveOff() = 0; // what is under way, which nobody will see the end of
    virtual void sendLast() {}   // before it is closed
    virtual void driverHasTold() {}
    virtual void show(std::size_t device, Shown &shown) const = 0;
    virtual void complete(Snapshot &made) = 0;

    void carryOutCommands()
    {
        bool isOther = false;
        while (auto next = mail.nextCommand()) {
            carryOutNext(*next);
            isOther = true;
        }
        if (isOther)
            publish();
    }
    void carryOut(command::StartJob &c)
    {
        Driver *its = driver(c.device);
        if (its == nullptr)
            return;
        auto taken = mayStart(*its, c.job);
        if (taken && its->busy())
            taken = refuse(RefusalKind::busy, RefusalId::jobRunning, {placeOf(*its).toString()});
        if (taken)
            taken = its->begin(c.id, c.job, c.pace, link.now());
        if (!taken)
            tellEvent(Event(notTaken(c.id, taken.error(), its->reading().state)), c.device);
        collect(c.device);
        settleDevice(c.device);
    }
    void carryOut(command::Proceed &c)
    {
        if (driver(c.device) == nullptr)
            return;
        driver(c.device)->proceed();
        settleDevice(c.device);
    }
    // The job may have ended while the command was on its way.
    void carryOut(command::Cancel &c)
    {
        if (driver(c.device) == nullptr || !driver(c.device)->busy())
            return;
        driver(c.device)->cancel(c.how, link.now());
        collect(c.device);
        settleDevice(c.device);
    }
    void carryOut(command::SetKnown &c)
    {
        if (driver(c.device) != nullptr)
            driver(c.device)->setKnown(c.known);
    }
    void carryOut(command::RemoveDevice &c)
    {
        if (driver(c.device) == nullptr)
            return;
        if (driver(c.device)->busy())
            driver(c.device)->stop({RefusalKind::stopped, RefusalId::busStopped, {}}, link.now());
        collect(c.device);
        drivers[c.device].reset();
    }
    void carryOut(command::SetRunning &c)
    {
        if (c.on == state.running)
            return;
        state.running = c.on;
        if (!state.running)
            stopJobs({RefusalKind::stopped, RefusalId::busStopped, {}});
        settleAll();
        tell({.id = c.on ? MessageId::busStarted : MessageId::busStopped});
    }
    void carryOut(command::SetOperate &c)
    {
        if (c.on == state.operate || !state.connected)
            return;
        if (const auto busy = busyRefusal()) {
            tell({.severity = Severity::attention, .refusal = busy});
            return;
        }
        if (!useOperate(c.on))
            return;
        settleAll();
        tell({.id = c.on ? MessageId::operateOn : MessageId::watchOn});
    }
    virtual bool useOperate(bool on) // false: the link is gone
    {
        state.operate = on;
        return true;
    }
    void carryOut(command::AlarmStop & /*c*/)
    {
        dropTyped();
        endScan(true);
        stopJobs({RefusalKind::stopped, RefusalId::alarmStop, {}});
    }
    void carryOut(command::CancelScan & /*c*/) { endScan(true); }

    void endAll(const Refusal &why)
    {
        stopJobs(why);
        dropTyped();
        endScan(true);
    }
    void stopJobs(const Refusal &why)
    {
        for (std::size_t device = 0; device < drivers.size(); ++device)
            stopJob(device, why);
    }
    void stopJob(std::size_t device, const Refusal &why)
    {
        if (driver(device) == nullptr || !driver(device)->busy())
            return;
        driver(device)->stop(why, link.now());
        collect(device);
        jobStopped(device);
    }
    std::optional<Refusal> busyRefusal() const // that a job runs
    {
        for (const auto &its : drivers)
            if (its && its->busy())
                return Refusal{RefusalKind::busy, RefusalId::jobRunning, {placeOf(*its).toString()}};
        return std::nullopt;
    }
    void settleAll()
    {
        for (std::size_t device = 0; device < drivers.size(); ++device)
            if (driver(device) != nullptr)
                settleDevice(device);
    }

    void linkIsGone(const Refusal &why)
    {
        state.connected = false;
        state.whyLost = why;
        reopenAt = link.now() + betweenTries;
        notBack = {why};
        tellGone(why);
        stopJobs(why);
        state.operate = false;
        leaveOff();
        dropTyped();
        endScan(true);
        for (std::size_t device = 0; device < drivers.size(); ++device)
            if (driver(device) != nullptr) {
                driver(device)->lost(link.now());
                collect(device);
            }
        forget();
        link.close();
        publish();
    }
    void waitForLink(Instant until)
    {
        carryOutCommands();
        if (link.now() < reopenAt)
            link.wait(std::min(until, reopenAt));
        else
            tryToReopen();
    }
    // That it is missing was reported. Each other thing in the way is reported once, also if they alternate.
    void tryToReopen()
    {
        reopenAt = link.now() + betweenTries;
        if (const auto opened = reopenLink(); !opened) {
            const bool isNew = std::ranges::find(notBack, opened.error()) == notBack.end();
            if (isNew)
                notBack.push_back(opened.error());
            tellNotBack(opened.error(), isNew);
            return;
        }
        state.connected = true;
        state.whyLost.reset();
        linkIsBack();
        publish();
    }

    Driver *driver(std::size_t device) const
    {
        return device < drivers.size() ? drivers[device].get() : nullptr;
    }
    void collect(std::size_t device)
    {
        std::vector<Event> events = driver(device)->takeEvents();
        for (Event &event : events)
            tellEvent(std::move(event), device);
        for (Message &message : driver(device)->takeMessages()) {
            message.place = placeOf(*driver(device));
            tell(std::move(message));
        }
        if (!events.empty())
            driverHasTold();
    }
    void tellEvent(decltype(BusEvent::what) what, std::size_t device = 0)
    {
        mail.tell({.device = device, .what = std::move(what), .at = link.now()});
    }
    void tell(Message message)
    {
        message.at = link.now();
        tellEvent(std::move(message));
    }
    void look(std::size_t device) // at what it shows
    {
        tap.look(device, driver(device)->reading(), state.connected && state.running, link.now());
    }
    void publish()
    {
        Snapshot made;
        static_cast<State &>(made) = state;
        made.at = link.now();
        made.awakeSince = awakeSince;
        made.droppedRows = mail.droppedRows();
        for (std::size_t device = 0; device < drivers.size(); ++device) {
            Shown &shown = made.devices.emplace_back();
            const Driver *its = driver(device);
            shown.present = its != nullptr;
            if (its != nullptr) {
                shown.node = placeOf(*its).node;
                shown.reading = its->reading();
                shown.hasJob = its->busy();
                look(device);
            }
            show(device, shown);
        }
        complete(made);
        mail.note(tap.noted());
        tap.clear();
        mail.publish(made);
    }

    Link &link;
    std::vector<std::unique_ptr<Driver>> drivers; // null: removed
    State state{};
    ValueTap tap{};
    Instant awakeSince{};
    Instant reopenAt{};
    std::vector<Refusal> notBack{}; // why, as reported
    Mail &mail;
};

} // namespace codewheel
