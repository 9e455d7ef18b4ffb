// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "can/can_refusals.h"
#include "can/simulator/simulated_can_link.h"
#include "catalog/catalog.h"
#include "kinds/canopen/bus/canopen_bus_messages.h"
#include "kinds/canopen/bus/canopen_session.h"
#include "kinds/canopen/protocol/frames.h"
#include "kinds/canopen/simulator/simulated_canopen_plant.h"

#include <algorithm>
#include <deque>
#include <gtest/gtest.h>
#include <vector>

namespace codewheel::test {

using namespace std::chrono_literals;

inline CanFrame canFrame(std::uint32_t id, std::vector<std::uint8_t> data)
{
    return canopen::frameOf(id, data);
}

// A link that passes everything on, notes what is sent, and fails as it is told.
class WatchedCanLink final : public CanLink
{
public:
    explicit WatchedCanLink(const std::shared_ptr<SimulatedCanBus> &bus)
        : m_link(bus)
    {}

    std::vector<CanFrame> sent;
    std::vector<CanUse> uses;
    bool isGone = false;
    std::optional<Refusal> inTheWay{}; // of opening it while it is gone
    bool isFull = false;
    bool tellsFates = true;                            // whether it says what became of what was sent
    bool isUnsure = false;                             // whether it only listens
    std::optional<Refusal> remarked{};                 // of it once it is open
    std::function<bool(const CanFrame &)> goneAfter{}; // it is gone once this has gone out
    std::shared_ptr<SimulatedCanAdapter> adapter() const { return m_link.adapter(); }

    Result<void> open(CanUse use) override
    {
        if (isGone)
            return inTheWay ? Result<void>(tl::unexpected(*inTheWay)) : gone();
        if (use == CanUse::watch && isUnsure)
            return refuse(RefusalKind::link, CanRefusalId::watchNotSure, {name()});
        uses.push_back(use);
        return m_link.open(use);
    }
    void close() override { m_link.close(); }
    void takeUnsureWatch() override { isUnsure = false; }
    Instant now() const override { return m_link.now(); }
    void wait(Instant until) override { m_link.wait(until); }
    Result<CanNews> receive(Instant until) override
    {
        auto news = isGone ? Result<CanNews>(gone()) : m_link.receive(until);
        if (news && !tellsFates)
            std::ranges::fill(news->fates, CanFate::notKnown);
        return news;
    }
    Result<bool> send(const CanFrame &frame) override
    {
        if (isFull)
            return false;
        sent.push_back(frame);
        const auto taken = m_link.send(frame);
        if (goneAfter && goneAfter(frame)) {
            m_link.wait(m_link.now() + 200us); // it arrives, and its answer does not
            isGone = true;
        }
        return taken;
    }
    CanStatus status() const override { return m_link.status(); }
    std::optional<Refusal> remark() const override { return remarked; }
    QString name() const override { return m_link.name(); }
    bool isSimulated() const override { return true; }
    void interrupt() override { m_link.interrupt(); }

private:
    static tl::unexpected<Refusal> gone()
    {
        return refuse(RefusalKind::link, CanRefusalId::interfaceLost, {QStringLiteral("can0")});
    }

    SimulatedCanLink m_link;
};

// Somebody else on the bus, who says what he is told.
class Talker final : public CanParticipant
{
public:
    std::deque<CanFrame> frames;
    int answersAs = 0; // a node: SDO requests to it

    int rate() const override { return 125'000; }
    const CanFrame *toSend() const override { return frames.empty() ? nullptr : &frames.front(); }
    void sent(const CanFrame & /*frame*/, Instant /*now*/) override { frames.pop_front(); }
    void take(const CanFrame &frame, Instant /*now*/) override
    {
        if (answersAs != 0 && frame.id == 0x600U + static_cast<unsigned>(answersAs))
            frames.push_back(canFrame(frame.id - 0x80,
                                      {0x43, frame.bytes[1], frame.bytes[2], frame.bytes[3], 77, 0, 0, 0}));
    }
};

// The training plant, a session on it, and another one who talks.
class CanopenPlant : public testing::Test
{
protected:
    static constexpr Place five{firstCanBus, NodeId("can:5")};
    static constexpr Place six{firstCanBus, NodeId("can:6")};

    CanopenPlant() { connectTo(canopen::trainingEncoders()); }

    void connectTo(const std::vector<canopen::CanopenEncoderPlan> &encoders)
    {
        bus.reset();
        plant = std::make_unique<canopen::SimulatedCanopenPlant>(encoders);
        talker = std::make_shared<Talker>();
        plant->bus()->add(talker);
        auto made = std::make_unique<WatchedCanLink>(plant->bus());
        link = made.get();
        bus = std::make_unique<CanopenSession>(std::move(made), catalog,
                                               QDateTime(QDate(2026, 11, 21), QTime(12, 0)));
        QObject::connect(bus.get(), &CanopenSession::messaged, bus.get(),
                         [this](const Message &message) { messages.push_back(message); });
        QObject::connect(bus.get(), &CanopenSession::passed, bus.get(),
                         [this](const CanopenRow &row) { rows.push_back(row); });
    }
    void open(EncoderBus::Start start)
    {
        ASSERT_TRUE(bus->open({}, start, EncoderBus::Drive::byHand));
        ASSERT_TRUE(bus->add(5, QStringLiteral("canopen-406-single-turn")));
        ASSERT_TRUE(bus->add(6, QStringLiteral("canopen-406-multi-turn")));
    }
    void operate(Instant settling = 2s)
    {
        open(EncoderBus::Start::operating);
        bus->advance(settling);
    }
    void say(const CanFrame &frame)
    {
        plant->bus()->locked([&] { talker->frames.push_back(frame); });
    }
    // Empty: it has not ended.
    std::optional<Outcome> carryOut(Place place, const Job &job, Instant within = 20s)
    {
        std::optional<Outcome> outcome;
        EncoderSession *encoder = bus->encoder(place);
        const auto waiting = QObject::connect(encoder, &EncoderSession::finished, bus.get(),
                                              [&](const Outcome &ended) { outcome = ended; });
        const auto started = encoder->start(job, Pace::byItself);
        refused = started ? std::nullopt : std::optional(started.error());
        for (Instant passed{}; started && !outcome && passed < within; passed += 50ms)
            bus->advance(50ms);
        QObject::disconnect(waiting);
        return outcome;
    }
    int countOf(MessageCode id) const
    {
        return static_cast<int>(std::ranges::count(messages, id, &Message::id));
    }
    bool isRefusalTold(RefusalCode id) const
    {
        return std::ranges::any_of(
            messages, [&](const Message &message) { return message.refusal && message.refusal->id == id; });
    }
    int sentTo(std::uint32_t id) const
    {
        return static_cast<int>(std::ranges::count(link->sent, id, &CanFrame::id));
    }
    canopen::NmtState stateOf(std::size_t which)
    {
        return plant->withEncoder(which, [](canopen::SimulatedNode &node) { return node.state(); });
    }

    const Catalog catalog = Catalog::builtIn();
    std::unique_ptr<canopen::SimulatedCanopenPlant> plant;
    std::shared_ptr<Talker> talker;
    std::unique_ptr<CanopenSession> bus;
    WatchedCanLink *link = nullptr;
    std::vector<Message> messages;
    std::vector<CanopenRow> rows;
    std::optional<Refusal> refused;
};

} // namespace codewheel::test
