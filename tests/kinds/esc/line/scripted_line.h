// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/esc/driver/esc_request_driver.h"
#include "serial/byte_link.h"

#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <vector>

namespace codewheel {

// A line in virtual time with scripted answers, byte for byte, which records what was sent and when.
class ScriptedLink final : public ByteLink
{
public:
    struct Sent
    {
        Instant at;
        int baudRate;
        QByteArray bytes;
    };

    struct Talk
    {
        Instant at;
        QByteArray bytes;
        Instant every{}; // 0: it comes once
    };

    // The delay of answers after the request was handed over.
    Instant delay{5'000};
    Instant readsLate{}; // so long after the bytes came, as on a busy computer
    // By the bytes sent, at any baud rate or only at one.
    std::map<QByteArray, QByteArray> answers;
    std::optional<int> answersAt; // baud rate
    QByteArray chatter;           // comes by itself, again and again
    std::optional<Talk> talk;     // comes by itself at its times
    bool echoes = false;          // what is sent, as a half-duplex adapter
    bool unplugged = false;
    bool isOther = false; // the adapter
    LowLatency latency = LowLatency::granted;
    std::vector<Sent> sent;
    int opened = 0;
    int tries = 0; // of opening

    Result<void> open(const SerialSettings &settings) override;
    void close() override {}
    Result<void> setBaudRate(int baudRate) override;
    Instant now() const override { return m_now; }
    Result<void> write(const QByteArray &bytes) override;
    Result<QByteArray> read(Instant until) override;
    void wait(Instant until) override { m_now = std::max(m_now, until); }
    void interrupt() override {}
    void takeOtherAdapter() override { isOther = false; }
    LowLatency lowLatency() const override { return latency; }
    QString name() const override { return QStringLiteral("scripted line"); }
    bool isSimulated() const override { return true; }

    void letPass(Instant duration) { m_now += duration; }
    std::vector<QByteArray> sentTexts() const; // without ESC and CR LF

private:
    struct Coming
    {
        Instant at;
        QByteArray bytes;
    };

    QByteArray takeTalk();

    Instant m_now{};
    int m_baudRate = 0;
    std::deque<Coming> m_coming;
};

// Polls the position of its address every `period`, and keeps what it was told.
class PollingDriver final : public RequestDriver
{
public:
    PollingDriver(EscLineAddress address, Instant period)
        : m_address(address)
        , m_period(period)
    {}

    const Reading &reading() const override { return m_reading; }
    bool busy() const override { return m_job.has_value(); }
    void setKnown(const std::vector<Known> &) override {}
    Result<void> begin(JobId id, const Job &, Pace, Instant) override;
    void proceed() override {}
    void cancel(OnCancel, Instant) override {}
    void stop(const Refusal &why, Instant now) override;
    std::optional<Instant> wakesAt() const override { return m_wakesAt; }
    std::optional<esc::Request> next(Instant now) override;
    void answered(const esc::Request &request, const esc::ExchangeResult &result, Instant now) override;
    EscLineAddress address() const override { return m_address; }
    std::optional<int> wantedBaudRate() const override { return m_baudRate; }
    void setFractionBits(int bits) override { m_fractionBits = bits; }
    std::vector<Event> takeEvents() override { return std::exchange(m_events, {}); }
    std::vector<Message> takeMessages() override { return std::exchange(m_messages, {}); }

    void moveTo(EscLineAddress address) { m_address = address; }
    void say(Message message) { m_messages.push_back(std::move(message)); } // with the next request
    void speakAt(int baudRate) { m_baudRate = baudRate; }
    std::optional<int> fractionBits() const { return m_fractionBits; } // as told

private:
    EscLineAddress m_address;
    Instant m_period;
    std::optional<int> m_baudRate; // unset: the line's
    std::optional<int> m_fractionBits;
    Instant m_wakesAt{};
    Reading m_reading;
    std::optional<JobId> m_job;
    std::vector<Event> m_events;
    std::vector<Message> m_messages;
};

} // namespace codewheel
