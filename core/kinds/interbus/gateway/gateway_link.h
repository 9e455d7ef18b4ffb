// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/gateway/gateway_counter.h"
#include "kinds/interbus/gateway/gateway_map.h"
#include "kinds/interbus/gateway/register_tries.h"
#include "kinds/interbus/gateway/sent_zeros.h"
#include "kinds/interbus/gateway/word_gate.h"
#include "kinds/interbus/ring/process_data_link.h"

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace codewheel {

// A device of a ring behind a gateway, as planned: a gateway has no ID cycle.
struct GatewayDevice
{
    RingDevice participant;
    std::optional<Profile> profile{}; // empty: not known
};

// The link to a ring whose process image a gateway shows as Modbus registers. One exchange writes all OUT
// words and reads all IN words, in as few transactions as possible; transactions without a valid answer are
// repeated. The gateway runs the ring by itself, so words are not bounded to its cycles.
//
// Nothing is ever written but by exchange() and sendZeros(). What the gateway does not let be read back is
// written only to devices whose OUT was asked for (claimOut()). Before each write of exchange() OUT is read
// back: what somebody else has put there is not overwritten (outNotOurs). Between this read and the write
// there is a gap of one transaction, in which Modbus gives no hold on the registers: a word that somebody
// else writes just then is overwritten unseen; the next one of a peer that writes again and again is not. An
// IN word counts once the reads agree (WordGate).
class GatewayLink final : public ProcessDataLink
{
public:
    GatewayLink(std::unique_ptr<RegisterPort> port, GatewaySettings settings,
                const std::vector<GatewayDevice> &ring);
    ~GatewayLink() override;

    // The port's refusals, and registerMapWrong, gatewayHasNoDevices; reads IN once, so that a wrong unit or
    // an image that is too short is noticed: registersUnanswered, registersRefused, registersGarbled.
    Result<RingStructure> open() override;
    void close() override;
    Result<std::vector<Word>> readBackOut() override;
    Result<void> exchange(std::span<const Word> out, std::span<Word> in) override;
    Result<void> watch(std::span<Word> out, std::span<Word> in) override;
    // Waits until they are read back, as long as a gateway may take to show them (OwnWord::gatewayLag), and
    // sends them once more if they are not.
    Result<ZerosSent> sendZeros(std::span<Word> in) override;
    void hurryToZeros() override { m_hurriesToZeros = true; }
    bool sendZerosUnheard() override;
    SentZeros sentZeros() const { return m_zeros.told(); } // any thread
    std::vector<QString> outPlaces() const override;
    Result<void> acknowledgeWatchdog() override;
    void claimOut(std::size_t device) override;
    bool writesOut(std::size_t device) const override;
    std::optional<ToldRing> toldRing() const override { return m_told; }
    bool isUpToDate(std::size_t device) const override;
    std::optional<Instant> age(std::size_t device) const override;
    std::shared_ptr<const LinkFigures> figures() const override { return m_counter.figures(); }
    LinkFigures figuresNow(); // of this moment
    std::optional<DataCheck> checkWord(std::size_t device, Word in,
                                       const EncoderSession &encoder) const override;
    Instant now() const override { return m_port->now(); }
    // While open: no longer than until the next exchange is due; not at all if it is.
    void wait(Instant until) override;
    bool isDue() const override { return !m_map || now() >= m_nextExchange; }
    bool boundsWordsToCycles() const override { return false; }
    bool findsDevices() const override { return false; }
    void interrupt() override { m_port->interrupt(); }

private:
    struct Device;
    enum class Overwrites : std::uint8_t { ours, anything };

    Result<void> checkUse(std::size_t outWords, std::size_t inWords) const;
    void settle(Instant begun);

    // IN (gateway_link_words.cpp)
    Result<void> readIn();
    Result<void> readDoubtfulAgain();
    Result<void> readBlock(const RegisterBlock &block);
    void takeBlock(const RegisterBlock &block);
    void beginToRead();
    void showIn(std::span<Word> in);
    bool isDoubtful(std::size_t device) const;
    bool needsAnotherRead(std::size_t device) const;
    bool hasDoubtful(const RegisterBlock &block) const;
    bool pollsSeldom() const;
    bool needsTime(const RegisterBlock &block) const;
    void countDoubts();
    Result<void> readStatus();
    Result<Register> readRegister(int first);

    // OUT (gateway_link_out.cpp)
    Result<void> readOut(std::vector<Word> &words);
    Result<void> readOutUntilItAgrees(std::vector<Word> &words);
    bool cannotReadBack(const Refusal &why) const;
    bool canReadSomeOut();
    Result<void> waitUntilOwnWordsShow();
    Result<void> checkIsOurs();
    Result<void> readWhetherOurs();
    std::uint64_t reconnections() const;
    bool hasReconnected();
    bool showsOwnWords(const std::vector<Word> &there) const;
    Result<void> waitForOwnWords();
    Result<void> checkBlindWriting();
    std::vector<std::size_t> notOurs(const std::vector<Word> &there);
    void showOut(std::size_t device, Word there, Word &out);
    Result<void> writeOut(std::span<const Word> out, Overwrites overwrites);
    bool putOut(std::span<const Word> out);
    Result<void> writeBlocks(Overwrites overwrites);
    bool writesLess(const Refusal &why, const RegisterBlock &block);
    Result<void> writeBlock(const RegisterBlock &block, Overwrites overwrites);
    Result<void> writeAndReadBlock(const RegisterBlock &block, const RegisterBlock &in,
                                   Overwrites overwrites);
    void claimAll();
    Result<void> writeZeros();
    // What came of zeros that were sent once.
    struct ZerosByDevice
    {
        bool isTaken = false; // by some
        bool isCut = false;   // not all were answered
        bool mayHaveArrived = false;
        std::vector<std::size_t> refusedBy{};

        bool areAllTaken() const { return isTaken && !isCut && refusedBy.empty(); }
        void take(const RegisterPort::Done &done);
    };
    ZerosByDevice writeZerosOneByOne(const GatewayMap &map);
    RegisterPort::Done writeZerosOnce(const RegisterBlock &block);
    void noteZeros(const ZerosByDevice &all);
    Result<ZerosSent> areZerosThere();

    // Transactions (gateway_link_words.cpp).
    RegisterPort::Done readOnce(const std::function<RegisterPort::Done()> &call, bool again);
    RegisterPort::Done transact(const std::function<RegisterPort::Done()> &call, bool again);
    Result<void> ask(int function, const RegisterBlock &block,
                     const std::function<RegisterPort::Done()> &call);
    Result<bool> send(int function, const RegisterBlock &block,
                      const std::function<RegisterPort::Done()> &call, Overwrites overwrites);
    void noteSent(const RegisterPort::Done &done, const RegisterBlock &block);
    bool connectsAgain(RegisterTries &tries);
    bool mayFollowClosing(const RegisterError &error) const;

    const std::unique_ptr<RegisterPort> m_port;
    const GatewaySettings m_settings;
    RingStructure m_ring;
    std::vector<Device> m_devices;
    std::optional<GatewayMap> m_map;      // empty: not open
    bool m_readsBack = false;             // OUT, as far as the gateway lets it be
    bool m_hasReadBack = false;           // it did so once, so it can
    std::vector<RegisterBlock> m_written; // of OUT, in each exchange
    std::optional<ToldRing> m_told;
    std::vector<Register> m_inRegisters;
    std::vector<Register> m_outRegisters;  // to be written
    std::vector<Register> m_backRegisters; // as read back
    GatewayCounter m_counter;
    ZerosRecord m_zeros;
    Instant m_answeredAt{}; // the last transaction: half-way between request and answer
    Instant m_answerTook{};
    Instant m_nextExchange{};
    bool m_hasExchanged = false; // since the last wait()
    Instant m_nextStatus{};
    std::atomic<bool> m_hurriesToZeros = false;
    bool m_isWriting = false;               // in exchange() or sendZeros()
    bool m_mayBeSent = false;               // any OUT, in this exchange
    std::uint64_t m_connectedAgain = 0;     // by us, to a gateway that does not close each connection
    std::uint64_t m_reconnections = 0;      // that OUT was looked at after
    std::optional<Instant> m_lastWriteAt{}; // tried, on whatever connection
};

} // namespace codewheel
