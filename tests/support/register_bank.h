// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/gateway/register_port.h"

#include <atomic>
#include <functional>
#include <map>
#include <memory>
#include <optional>

namespace codewheel::test {

// The registers of a simulated gateway.
struct RegisterBank
{
    std::map<int, Register> input;
    std::map<int, Register> holding;
    int inputEnd = 65'536; // the first register that does not exist
    int holdingEnd = 65'536;
    int writes = 0;
    Instant busyUntil{}; // it refuses everything with busyCode
    int busyCode = 6;
    std::size_t mostWritten = 123; // in one request; more is exception 3
    // The register that acknowledges its watchdog, which has tripped: every other write is exception 4.
    std::optional<int> tripped{};
    std::optional<int> blockException{}; // of each write of more than one word
    std::function<void()> onWrite;       // after each one

    std::map<int, Register> &of(RegisterArea area) { return area == RegisterArea::input ? input : holding; }
    int endOf(RegisterArea area) const { return area == RegisterArea::input ? inputEnd : holdingEnd; }
};

// A port to it, in virtual time: each transaction takes a millisecond.
class RegisterBankPort : public RegisterPort
{
public:
    explicit RegisterBankPort(std::shared_ptr<RegisterBank> bank)
        : m_bank(std::move(bank))
    {}

    Result<void> open() override
    {
        m_open = true;
        return {};
    }
    void close() override { m_open = false; }
    Done read(RegisterArea area, int first, std::span<Register> to) override
    {
        if (auto begun = begin(); !begun)
            return begun;
        if (first + static_cast<int>(to.size()) > m_bank->endOf(area))
            return exception(2);
        for (std::size_t i = 0; i < to.size(); ++i)
            to[i] = m_bank->of(area)[first + static_cast<int>(i)];
        return {};
    }
    Done write(int first, std::span<const Register> from) override
    {
        if (auto begun = begin(); !begun)
            return begun;
        if (first + static_cast<int>(from.size()) > m_bank->holdingEnd)
            return exception(2);
        if (from.size() > m_bank->mostWritten)
            return exception(3);
        if (m_bank->tripped.value_or(first) != first)
            return exception(4);
        m_bank->tripped.reset();
        if (m_bank->blockException && from.size() > 2)
            return exception(*m_bank->blockException);
        put(first, from);
        return {};
    }
    Done writeAndRead(int writeFirst, std::span<const Register> from, int readFirst,
                      std::span<Register> to) override
    {
        if (auto written = write(writeFirst, from); !written)
            return written;
        return read(RegisterArea::holding, readFirst, to);
    }
    Instant now() const override { return m_now; }
    void wait(Instant until) override { m_now = std::max(m_now, until); }
    void interrupt() override { m_interrupted = true; }
    QString name() const override { return QStringLiteral("bank"); }

protected:
    static Done exception(int code)
    {
        return tl::unexpected(RegisterError{RegisterError::Kind::exception, code, {}});
    }
    static Done failed(RegisterError::Kind kind) { return tl::unexpected(RegisterError{kind, 0, {}}); }
    RegisterBank &bank() { return *m_bank; }

private:
    Done begin()
    {
        if (m_interrupted.exchange(false))
            return failed(RegisterError::Kind::stopped);
        if (!m_open)
            return failed(RegisterError::Kind::closed);
        m_now += std::chrono::milliseconds(1);
        return m_now < m_bank->busyUntil ? exception(m_bank->busyCode) : Done();
    }
    void put(int first, std::span<const Register> from)
    {
        for (const Register word : from)
            m_bank->holding[first++] = word;
        ++m_bank->writes;
        if (m_bank->onWrite)
            m_bank->onWrite();
    }

    std::shared_ptr<RegisterBank> m_bank;
    bool m_open = false;
    Instant m_now{};
    std::atomic<bool> m_interrupted{false};
};

} // namespace codewheel::test
