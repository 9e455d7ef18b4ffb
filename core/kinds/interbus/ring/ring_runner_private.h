// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/bus_mail.h"
#include "kinds/interbus/ring/exchange_trace.h"
#include "kinds/interbus/ring/master_text.h"
#include "kinds/interbus/ring/master_watch.h"
#include "kinds/interbus/ring/ring_guests.h"
#include "kinds/interbus/ring/ring_runner.h"
#include "kinds/interbus/ring/ring_watch.h"

namespace codewheel {

// What the files of the runner share.
struct RingRunner::Private
{
    // A device without a driver (K1, unknown) has a null pointer.
    using Drivers = std::vector<std::unique_ptr<CyclicDriver>>;

    Private(ProcessDataLink &usedLink, Mail &usedMail);

    // False: the zeros of an ALARM STOP have to go out first, and the rest waits.
    bool carryOutCommands();
    bool zerosGoNext() const;
    bool carryOutNext(); // false: there is none
    void carryOut(command::UseRing &c);
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
    void carryOut(command::OfferTo &c);
    void carryOut(command::AcknowledgeWatchdog);

    void work();
    void publish();
    void exchange();
    void catchUp();
    Result<void> sendZeros();
    void lookWhetherZerosStand();
    void tellZerosAtDevices();
    bool ringStands() const;
    void zerosAreBlockedBy(const Refusal &why);
    void tellZerosUnheard();
    void tellZeros(const ProcessDataLink::ZerosSent &zeros);
    void zeroAtRest();
    void fail(const Refusal &why);
    void giveWay(const Refusal &why);
    void step(std::size_t device);
    void endWhatWaitsTooLong(std::size_t device);
    void lookAtToldRing();
    void tellWritten();
    void showStandingWords();
    void leaveRun(MasterState state, const Refusal &why = {RefusalKind::stopped, RefusalId::busStopped, {}});
    void endJobs(const Refusal &why);
    void endJob(std::size_t device, const Refusal &why);
    void endJobs(RefusalCode why) { endJobs(Refusal{RefusalKind::stopped, why, {}}); }
    void goOnWithWhatWasExchanged();
    Word goesOn(std::size_t device, Word last) const;
    Result<void> mayWrite(std::size_t device, Word word) const;
    void takeBackWhatWatchDoesNotSend();
    void zeroOut();
    void refuseWord(std::size_t device, Refusal why);
    void refuseOfRing(const Refusal &why);

    // The link, and which ring there is (ring_runner_link.cpp).
    Result<RingFound> find();
    RingFound found(RingStructure there, std::vector<Word> out) const;
    void loseLink(const Refusal &why);
    void waitForLink();
    void tryToReopen();
    void comeBack();
    void tellOutIsUnknown();

    // Guests (ring_runner_guests.cpp).
    void carryOutGuestWords();
    Result<void> takeGuestWords(std::vector<GuestWord> &words);
    Result<void> whetherExchanged(bool isExchanged) const;
    void showGuests(bool isExchanged);
    void tellGuestWords(bool isExchanged);
    std::uint16_t statusRegister() const;

    // With a master (ring_runner_master.cpp).
    bool reaches(MasterService service);
    bool mayUse(MasterService service); // one of those that change what the ring does
    Result<void> startTransfer();
    Result<void> endActiveConfiguration();
    void takeActive(const RingStructure &active);
    void readInStep();
    void endReadIn(const Result<RingStructure> &read);
    void idle();
    void lookAtMaster();
    void lookAtStatus();
    void showWhoIsInRing(const MasterStatus &status);
    void leaveRing(std::size_t device);
    void takeDriverEvents(std::size_t device, std::optional<Word> left = {});
    void forgetDevices();
    void traceUnansweredWords();
    void tellUnheardWords();
    std::optional<Word> wordLeftThere(std::size_t i) const;
    std::optional<Word> wordLeftBy(const Refusal &why, std::size_t device) const;

    void tell(std::size_t device, decltype(RingEvent::what) what)
    {
        mail.tell({device, std::move(what), ring.at, ring.generation});
    }
    void tellOfRing(Message message);
    void tellOfRing(std::vector<Message> messages);
    void tellOfDevice(std::size_t device, Message message);

    ProcessDataLink &link;
    MasterLink *master; // null: the link reaches none
    Mail &mail;
    RingStructure structure{};
    Drivers drivers{};
    std::vector<Word> image{}; // OUT as it goes out next
    std::vector<Word> received{};
    std::vector<std::size_t> written{}; // by SetOut, and not yet exchanged
    Snapshot ring{};                    // the last cycle; its OUT words are those that went out
    ExchangeTrace trace{0};
    ValueTap tap{};
    FaultWatch faults{0};
    MasterWatch masterWatch{};
    std::uint64_t seenOfMaster = ~std::uint64_t{0}; // MasterLink::statusChanges()
    bool outIsKnown = true; // false: the peer did not tell it when the link was opened
    bool isClosing = false;
    bool readingIn = false;
    bool ringIsOther = false; // the ring is not ours: nothing can be exchanged
    bool runsAgain = false;   // once there is a ring to run: it ran before, or was started meanwhile
    bool zerosAreDue = false; // of an ALARM STOP that came while the bus runs, or while its link was lost
    std::uint64_t alarmStops = 0;
    struct GuestChange
    {
        std::size_t device;
        Word word;
        Word before; // what would have gone out
    };
    std::shared_ptr<RingGuests> guests{};     // null: the ring is offered to nobody
    std::vector<GuestChange> guestChanges{};  // in this cycle
    unsigned generationOfGuests = 0;          // of the ring that they were shown
    Instant reopenAt{};                       // of a lost link
    bool zerosAreBeforeRing = false;          // which does not run
    std::optional<Instant> zerosStandUntil{}; // so long it is looked whether they do
    Instant zerosAgainAt{};                   // those that were refused
    bool sentUnheard = false;                 // zeros, over the lost link: told
};

} // namespace codewheel
