// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/bus_mail.h"
#include "ring/exchange_trace.h"
#include "ring/master_text.h"
#include "ring/master_watch.h"
#include "ring/ring_runner.h"
#include "ring/ring_watch.h"

namespace codewheel {

// What the files of the runner share.
struct RingRunner::Private
{
    Private(ProcessDataLink &usedLink, RingStructure ring, Drivers usedDrivers,
            std::vector<Word> outAsReadBack);

    // False: an ALARM STOP was among them, and the rest waits.
    bool carryOutCommands();
    void carryOut(const command::SetOut &c);
    void carryOut(const command::StartJob &c);
    void carryOut(const command::Proceed &c) { drivers[c.device]->proceed(); }
    void carryOut(const command::Cancel &c);
    void carryOut(const command::SetKnown &c) { drivers[c.device]->setKnown(c.known); }
    void carryOut(command::SetDriver &c);
    void carryOut(command::StartBus);
    void carryOut(command::StopBus);
    void carryOut(command::SetOperate c);
    void carryOut(command::AlarmStop);
    void carryOut(command::ReadIn);
    void carryOut(const command::SwitchSegment &c);
    void carryOut(command::ConfirmDiagnostics);
    void carryOut(const command::KeepConfiguration &c);
    void carryOut(const command::AskKeptConfiguration &c);

    void exchange();
    void fail(const Refusal &why);
    void step(std::size_t device);
    void tellWritten();
    void showStandingWords();
    void leaveRun(MasterState state);
    void endJobs(RefusalId why);
    void goOnWithWhatWasExchanged();
    void takeBackWhatMustNotStand();
    void refuseWord(std::size_t device, Refusal why);
    void refuseOfRing(const Refusal &why);

    // With a master (ring_runner_master.cpp).
    bool reaches(MasterService service);
    bool mayUse(MasterService service); // of those that change what the ring does
    Result<void> startTransfer();
    Result<void> endActiveConfiguration();
    void readInStep();
    void endReadIn(Result<RingStructure> found);
    void idle();
    void lookAtMaster();
    void lookAtStatus();
    void showWhoIsInRing(const MasterStatus &status);
    void leaveRing(std::size_t device);
    void takeDriverEvents(std::size_t device);

    void tell(std::size_t device, decltype(RingEvent::what) what)
    {
        mail.tell({device, std::move(what), ring.at});
    }
    void tellOfRing(Message message);
    void tellOfRing(std::vector<Message> messages);
    void tellOfDevice(std::size_t device, Message message);

    ProcessDataLink &link;
    MasterLink *master; // null: the link reaches none
    RingStructure structure;
    Drivers drivers;
    std::vector<Word> image; // OUT as it goes out next
    std::vector<Word> received;
    std::vector<std::size_t> written; // by SetOut, and not exchanged yet
    Snapshot ring;                    // the last cycle; its OUT words are those that went out
    ExchangeTrace trace;
    FaultWatch faults;
    LatenessWatch lateness;
    BusMail<Command, RingEvent, Snapshot> mail;
    MasterWatch masterWatch;
    std::uint64_t seenOfMaster = ~std::uint64_t{0}; // MasterLink::statusChanges()
    bool linkFailed = false;                        // whatever the master said last
    bool readingIn = false;
    bool ringIsOther = false; // the master has another ring active than ours: nothing can be exchanged
};

} // namespace codewheel
