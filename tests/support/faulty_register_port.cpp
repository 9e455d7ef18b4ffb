// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/faulty_register_port.h"

#include <algorithm>
#include <array>
#include <utility>

namespace codewheel::test {
namespace {

using namespace std::chrono_literals;

constexpr std::array exceptionCodes{1, 2, 3, 4, 5, 6, 8, 10, 11};
constexpr Instant longestAway = 5s; // after a connection was closed
constexpr Instant longestSpell = 3s;
constexpr Instant lateAnswerIsKept = 1s; // until the line is quiet again

int endOf(int first, std::span<const Register> registers)
{
    return first + static_cast<int>(registers.size());
}

} // namespace

RegisterFaults RegisterFaults::ofAllKinds(double rate)
{
    return {.requestLost = rate,
            .answerLost = rate,
            .late = rate,
            .doubled = rate,
            .cut = rate,
            .exception = rate,
            .closed = rate / 4,
            .busy = rate / 4,
            .shortArea = rate / 8,
            .limited = rate / 8,
            .torn = rate};
}

FaultyRegisterPort::FaultyRegisterPort(std::unique_ptr<RegisterPort> port, unsigned seed,
                                       std::shared_ptr<Watch> watch)
    : m_port(std::move(port))
    , m_random(seed)
    , m_watch(std::move(watch))
{}

bool FaultyRegisterPort::happens(double rate, Kind kind)
{
    if (rate <= 0 || std::uniform_real_distribution<>(0, 1)(m_random) >= rate)
        return false;
    ++m_watch->faults[kind];
    return true;
}

Instant FaultyRegisterPort::someTime(Instant most)
{
    return Instant(std::uniform_int_distribution<Instant::rep>(0, most.count())(m_random));
}

RegisterPort::Done FaultyRegisterPort::failed(RegisterError::Kind kind)
{
    return tl::unexpected(RegisterError{kind, 0, {}});
}

Result<void> FaultyRegisterPort::open()
{
    close();
    if (now() < m_opensAgainAt)
        return refuse(RefusalKind::link, RefusalId::connectionRefused, {name()});
    auto opened = m_port->open();
    m_open = opened.has_value();
    if (m_open && m_watch->opened)
        m_watch->opened();
    return opened;
}

// What still came in meanwhile is dropped when a port is opened.
void FaultyRegisterPort::close()
{
    m_port->close();
    m_open = false;
    m_late.clear();
}

std::optional<RegisterPort::Done> FaultyRegisterPort::failBefore(const Request &request)
{
    if (!m_open)
        return failed(RegisterError::Kind::closed);
    if (happens(m_faults.closed, closed)) {
        close();
        m_opensAgainAt = now() + someTime(longestAway);
        return failed(RegisterError::Kind::closed);
    }
    if (happens(m_faults.requestLost, requestLost)) {
        // The answer to an earlier write is taken for that to one that is lost.
        if (request.function == 16 && takeLate(request))
            return Done();
        wait(now() + timeOut);
        return failed(RegisterError::Kind::noAnswer);
    }
    if (const int code = exceptionTo(request); code != 0) {
        wait(now() + 1ms);
        return tl::unexpected(RegisterError{RegisterError::Kind::exception, code, {}});
    }
    return std::nullopt;
}

bool FaultyRegisterPort::isInSpell(Instant &until, double rate, Kind kind)
{
    if (happens(rate, kind))
        until = now() + someTime(longestSpell);
    return now() < until;
}

// 0: none.
int FaultyRegisterPort::exceptionTo(const Request &request)
{
    if (isInSpell(m_busyUntil, m_faults.busy, busy))
        return 6;
    if (isInSpell(m_shortUntil, m_faults.shortArea, shortArea) && request.outEnd > shortEnd)
        return 2;
    if (isInSpell(m_limitedUntil, m_faults.limited, limited) && request.length > mostRegisters)
        return 3;
    return happens(m_faults.exception, exception) ? exceptionCodes.at(m_random() % exceptionCodes.size()) : 0;
}

std::optional<FaultyRegisterPort::Registers> FaultyRegisterPort::takeLate(const Request &request)
{
    std::erase_if(m_late, [this](const LateAnswer &one) { return now() - one.at > lateAnswerIsKept; });
    const auto found = std::ranges::find_if(m_late, [&](const LateAnswer &one) {
        return one.at <= now() && one.function == request.function && one.registers.size() == request.length;
    });
    if (found == m_late.end())
        return std::nullopt;
    Registers registers = std::move(found->registers);
    m_late.erase(found);
    ++m_watch->faults[staleAnswer];
    return registers;
}

// As ports do, of what can be read: two copies of one answer would be two reads that agree.
void FaultyRegisterPort::dropWhatHasCome(const Request &request)
{
    std::erase_if(m_late, [&](const LateAnswer &one) {
        return one.at <= now() && one.function == request.function && request.function != 16;
    });
}

void FaultyRegisterPort::keepLate(const Request &request, Registers registers, Instant at)
{
    registers.resize(request.length);
    m_late.push_back({request.function, std::move(registers), at});
}

RegisterPort::Done FaultyRegisterPort::transact(const Request &request, std::span<Register> to)
{
    dropWhatHasCome(request);
    if (auto failure = failBefore(request))
        return *failure;
    Registers registers(to.size());
    m_whole.clear();
    if (auto done = request.carryOut(registers); !done)
        return done;
    // A torn answer that comes again would be two reads that agree.
    const Registers whole = m_whole.empty() ? registers : m_whole;
    if (happens(m_faults.answerLost, answerLost)) {
        wait(now() + timeOut);
        return failed(RegisterError::Kind::noAnswer);
    }
    if (happens(m_faults.late, late)) {
        keepLate(request, whole, now() + timeOut + someTime(latest - timeOut));
        wait(now() + timeOut);
        return failed(RegisterError::Kind::noAnswer);
    }
    if (happens(m_faults.cut, cut))
        return failed(RegisterError::Kind::wrongAnswer);
    if (happens(m_faults.doubled, doubled))
        keepLate(request, whole, now());
    return answer(request, std::move(registers), to);
}

// The right answer comes after a late one, and may in turn be taken for that to a later request.
RegisterPort::Done FaultyRegisterPort::answer(const Request &request, Registers registers,
                                              std::span<Register> to)
{
    if (auto stale = takeLate(request)) {
        if (m_random() % 4 == 0)
            keepLate(request, m_whole.empty() ? std::move(registers) : m_whole, now());
        registers = *std::move(stale);
    }
    std::copy_n(registers.begin(), to.size(), to.begin());
    return {};
}

void FaultyRegisterPort::tear(RegisterArea area, int first, Registers &registers)
{
    m_whole = registers;
    const auto last = std::exchange(m_lastRead[{area, first}], {registers, now()});
    if (now() - last.at >= copyTime) // by then the other half has been copied, too
        return;
    const Registers &before = last.registers;
    for (std::size_t i = 0; before.size() == registers.size() && i < registers.size(); ++i)
        if (registers[i] != before[i] && happens(m_faults.torn, torn))
            registers[i] = before[i];
}

RegisterPort::Done FaultyRegisterPort::read(RegisterArea area, int first, std::span<Register> to)
{
    auto done = transact({area == RegisterArea::input ? 4 : 3, to.size(),
                          [&](Registers &registers) {
                              auto read = m_port->read(area, first, registers);
                              if (read)
                                  tear(area, first, registers);
                              return read;
                          },
                          area == RegisterArea::holding ? endOf(first, to) : 0},
                         to);
    if (done && m_watch->read)
        m_watch->read(area);
    return done;
}

RegisterPort::Done FaultyRegisterPort::write(int first, std::span<const Register> from)
{
    return transact({16, from.size(),
                     [&](Registers &) {
                         if (m_watch->writing)
                             m_watch->writing();
                         return m_port->write(first, from);
                     },
                     endOf(first, from)},
                    {});
}

RegisterPort::Done FaultyRegisterPort::writeAndRead(int writeFirst, std::span<const Register> from,
                                                    int readFirst, std::span<Register> to)
{
    return transact({23, to.size(),
                     [&](Registers &registers) {
                         if (m_watch->writing)
                             m_watch->writing();
                         return m_port->writeAndRead(writeFirst, from, readFirst, registers);
                     },
                     endOf(writeFirst, from)},
                    to);
}

} // namespace codewheel::test
