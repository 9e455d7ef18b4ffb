// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/register_bank.h"

#include <deque>
#include <random>

namespace codewheel::test {

// What goes wrong at a gateway, and what the test sees of it.
struct GatewayTrouble
{
    bool isAway = false; // connections are closed, and refused
    double noAnswers = 0;
    double exceptions = 0;
    double closed = 0;
    int writesToDrop = 0;    // acknowledged and not carried out
    bool isRestless = false; // the first device: no two reads agree
    Instant lag{};           // until a word that was written can be read back
    std::function<void()> opened;
    std::function<void(int first, std::span<const Register>)> writing; // is carried out next
};

// Registers of a gateway with such troubles.
class WatchedRegisters final : public RegisterBankPort
{
public:
    WatchedRegisters(const std::shared_ptr<RegisterBank> &bank, GatewayTrouble &trouble, unsigned seed = 1)
        : RegisterBankPort(bank)
        , m_trouble(trouble)
        , m_random(seed)
    {}

    Result<void> open() override
    {
        if (m_trouble.isAway)
            return refuse(RefusalKind::link, RefusalId::connectionRefused, {name()});
        if (m_trouble.opened)
            m_trouble.opened();
        return RegisterBankPort::open();
    }
    Done read(RegisterArea area, int first, std::span<Register> to) override
    {
        if (auto failure = fail())
            return *failure;
        if (m_trouble.isRestless)
            bank().input[0] = static_cast<Register>(0xC000 + ++m_reads % 100);
        auto done = RegisterBankPort::read(area, first, to);
        if (area == RegisterArea::holding && m_trouble.lag > Instant{})
            showLate(first, to);
        return done;
    }
    Done write(int first, std::span<const Register> from) override
    {
        const bool isCarriedOut = happens(0.5);
        auto failure = fail();
        if (failure && (failure->error().kind != RegisterError::Kind::noAnswer || !isCarriedOut))
            return *failure;
        if (m_trouble.writesToDrop > 0) {
            --m_trouble.writesToDrop;
            return {};
        }
        m_before.push_back({now(), bank().holding});
        if (m_trouble.writing)
            m_trouble.writing(first, from);
        auto done = RegisterBankPort::write(first, from);
        return failure ? *failure : done;
    }

    static constexpr Instant timeOut = std::chrono::milliseconds(500);

private:
    struct Before
    {
        Instant until{};
        std::map<int, Register> holding;
    };

    bool happens(double rate) { return rate > 0 && std::uniform_real_distribution<>(0, 1)(m_random) < rate; }
    std::optional<Done> fail()
    {
        if (m_trouble.isAway || happens(m_trouble.closed)) {
            close();
            return failed(RegisterError::Kind::closed);
        }
        if (happens(m_trouble.exceptions))
            return exception(6);
        if (!happens(m_trouble.noAnswers))
            return std::nullopt;
        wait(now() + timeOut);
        return failed(RegisterError::Kind::noAnswer);
    }
    void showLate(int first, std::span<Register> to)
    {
        while (!m_before.empty() && m_before.front().until <= now() - m_trouble.lag)
            m_before.pop_front();
        if (m_before.empty())
            return;
        for (Register &one : to)
            one = m_before.front().holding[first++];
    }

    GatewayTrouble &m_trouble;
    std::mt19937 m_random;
    std::deque<Before> m_before; // the registers, until each write
    int m_reads = 0;
};

} // namespace codewheel::test
