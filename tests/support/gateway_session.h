// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/catalog.h"
#include "kinds/interbus/ring/ring_session.h"
#include "kinds/interbus/simulator/training_bus.h"
#include "tests/support/places.h"
#include "tests/support/simulated_gateway.h"
#include "vocabulary/message.h"
#include "vocabulary/refusal_text.h"

#include <gtest/gtest.h>
#include <memory>
#include <utility>
#include <vector>

namespace codewheel::test {

inline const Catalog &builtInCatalog()
{
    static const Catalog builtIn = Catalog::builtIn();
    return builtIn;
}

struct GatewayMaking
{
    SimulatedGateway::Ways ways{};
    GatewaySettings settings{};
    Instant transaction = std::chrono::milliseconds(1);
    BusId id = firstBus;
    std::function<TrainingBus()> makeRing = [] { return makeTrainingBus(builtInCatalog()); };
};

// The training ring behind a gateway, with its session, in virtual time.
class GatewaySession
{
public:
    using MakePort = std::function<std::unique_ptr<RegisterPort>(std::unique_ptr<RegisterPort>)>;

    using MakeLink = std::function<std::unique_ptr<ProcessDataLink>(std::unique_ptr<ProcessDataLink>)>;

    // `around`: what stands between the gateway and its link, and between the link and its session.
    explicit GatewaySession(const GatewayMaking &making = {}, const MakePort &around = {},
                            const MakeLink &aroundLink = {})
        : training(making.makeRing())
        , ring(std::dynamic_pointer_cast<SimulatedRing>(training.controls))
        , gateway(std::make_shared<SimulatedGateway>(ring, making.ways))
    {
        std::unique_ptr<RegisterPort> port =
            std::make_unique<SimulatedGatewayPort>(gateway, making.transaction);
        if (around)
            port = around(std::move(port));
        std::unique_ptr<ProcessDataLink> link = std::make_unique<GatewayLink>(
            std::move(port), making.settings, gatewayDevices(*ring, builtInCatalog()));
        if (aroundLink)
            link = aroundLink(std::move(link));
        bus = std::make_unique<RingSession>(std::move(link), builtInCatalog(),
                                            QDateTime(QDate(2026, 3, 1), QTime(14, 2)), nullptr,
                                            RingSession::DriverFactory(), making.id);
        QObject::connect(bus.get(), &EncoderBus::messaged, bus.get(),
                         [this](const Message &message) { messages.push_back(message); });
    }

    EncoderSession &encoder(Place place) { return *bus->encoder(place); }
    // At most a minute of bus time.
    Outcome finish(Place place, const Job &job)
    {
        std::optional<Outcome> outcome;
        const auto ended = QObject::connect(&encoder(place), &EncoderSession::finished, bus.get(),
                                            [&](const Outcome &how) { outcome = how; });
        const auto started = encoder(place).start(job);
        EXPECT_TRUE(started);
        for (int i = 0; i < 6'000 && started && !outcome; ++i)
            bus->advance(std::chrono::milliseconds(10));
        QObject::disconnect(ended);
        EXPECT_TRUE(outcome) << "it does not end";
        return outcome.value_or(Outcome{});
    }
    std::size_t countOf(MessageCode id) const
    {
        return static_cast<std::size_t>(std::ranges::count(messages, id, &Message::id));
    }
    std::optional<Refusal> lastRefusal() const
    {
        const auto last = std::find_if(messages.rbegin(), messages.rend(),
                                       [](const Message &message) { return message.refusal.has_value(); });
        return last == messages.rend() ? std::nullopt : last->refusal;
    }
    bool isOutZero() const
    {
        return std::ranges::all_of(gateway->out(), [](Word word) { return word == 0; });
    }

    TrainingBus training;
    std::shared_ptr<SimulatedRing> ring;
    std::shared_ptr<SimulatedGateway> gateway;
    std::unique_ptr<RingSession> bus;
    std::vector<Message> messages;
};

inline std::string whyOf(const Outcome &outcome)
{
    return outcome.result ? "" : refusalKey(outcome.result.error().id).toStdString();
}

} // namespace codewheel::test
