// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/gateway/register_port.h"

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <random>
#include <vector>

namespace codewheel::test {

// How often each thing goes wrong, of one transaction.
struct RegisterFaults
{
    double requestLost = 0;
    double answerLost = 0;
    double late = 0;    // no answer within the time-out; it comes as that to a later request
    double doubled = 0; // the second one comes as that to a later request
    double cut = 0;     // the answer is damaged
    double exception = 0;
    double closed = 0;
    double busy = 0;      // for a while: every transaction is refused
    double shortArea = 0; // for a while: its OUT ends at shortEnd (exception 2)
    double limited = 0;   // for a while: no more than mostRegisters in a request (exception 3)
    double torn = 0;      // of the words read: one register as the last read gave it

    static RegisterFaults ofAllKinds(double rate);
};

// A port on which transactions go wrong, in the port's virtual time. Answers that come late are told from the
// right one by their function and length, as on Modbus RTU.
class FaultyRegisterPort final : public RegisterPort
{
public:
    // What it does to the gateway behind it, for the test to check.
    struct Watch
    {
        std::function<void()> opened;
        std::function<void(RegisterArea)> read; // and answered
        std::function<void()> writing;          // reaches the gateway
        std::map<int, int> faults{};            // how many of each kind were made
    };
    enum Kind {
        requestLost,
        answerLost,
        late,
        doubled,
        cut,
        exception,
        closed,
        busy,
        shortArea,
        limited,
        torn,
        staleAnswer,
        kinds
    };

    FaultyRegisterPort(std::unique_ptr<RegisterPort> port, unsigned seed, std::shared_ptr<Watch> watch);

    // Of the faults from now on.
    void make(const RegisterFaults &faults) { m_faults = faults; }

    Result<void> open() override;
    void close() override;
    Done read(RegisterArea area, int first, std::span<Register> to) override;
    Done write(int first, std::span<const Register> from) override;
    Done writeAndRead(int writeFirst, std::span<const Register> from, int readFirst,
                      std::span<Register> to) override;
    Instant now() const override { return m_port->now(); }
    void wait(Instant until) override { m_port->wait(until); }
    void interrupt() override { m_port->interrupt(); }
    QString name() const override { return m_port->name(); }

    static constexpr Instant timeOut = std::chrono::milliseconds(500);
    static constexpr Instant latest = std::chrono::seconds(2); // a late answer is after its request
    static constexpr int shortEnd = 6;
    static constexpr std::size_t mostRegisters = 4;

private:
    using Registers = std::vector<Register>;
    struct LateAnswer
    {
        int function = 0;
        Registers registers;
        Instant at{};
    };
    // A request: what it does at the gateway, and where its answer goes.
    struct Request
    {
        int function = 0;
        std::size_t length = 0; // that of its answer
        std::function<Done(Registers &)> carryOut;
        int outEnd = 0; // behind the last holding register
    };

    bool happens(double rate, Kind kind);
    Done transact(const Request &request, std::span<Register> to);
    // What is answered without the gateway, if that is.
    std::optional<Done> failBefore(const Request &request);
    int exceptionTo(const Request &request);
    bool isInSpell(Instant &until, double rate, Kind kind);
    Done answer(const Request &request, Registers registers, std::span<Register> to);
    std::optional<Registers> takeLate(const Request &request);
    void dropWhatHasCome(const Request &request);
    void keepLate(const Request &request, Registers registers, Instant at);
    void tear(RegisterArea area, int first, Registers &registers);
    Instant someTime(Instant most);
    static Done failed(RegisterError::Kind kind);

    std::unique_ptr<RegisterPort> m_port;
    std::mt19937 m_random;
    std::shared_ptr<Watch> m_watch;
    RegisterFaults m_faults;
    bool m_open = false;
    Instant m_opensAgainAt{};
    Instant m_busyUntil{};
    Instant m_shortUntil{};
    Instant m_limitedUntil{};
    std::deque<LateAnswer> m_late;
    struct LastRead
    {
        Registers registers;
        Instant at{};
    };
    static constexpr Instant copyTime = std::chrono::milliseconds(3); // spec modbus-gateway.md

    std::map<std::pair<RegisterArea, int>, LastRead> m_lastRead;
    Registers m_whole; // of the last read, before it was torn
};

} // namespace codewheel::test
