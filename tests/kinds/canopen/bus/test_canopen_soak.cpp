// SPDX-License-Identifier: GPL-3.0-or-later
// Anything in any order, on a bus with faults: whatever was asked ends, and ends once.
#include "tests/kinds/canopen/bus/canopen_plant.h"

#include <random>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

class CanopenSoak : public test::CanopenPlant, public testing::WithParamInterface<unsigned>
{
protected:
    struct Count
    {
        int begun = 0;
        int ended = 0;
    };

    CanopenSoak()
    {
        plant->bus()->setFaults({.lost = 5, .damaged = 20, .doubled = 5, .late = 2});
        QObject::connect(bus.get(), &CanopenSession::transferEnded, bus.get(), [this] { ++transfers.ended; });
        QObject::connect(bus.get(), &CanopenSession::configured, bus.get(), [this] { ++services.ended; });
        QObject::connect(bus.get(), &CanopenSession::frameSent, bus.get(), [this] { ++frames.ended; });
    }
    int draw(int below) { return static_cast<int>(m_random() % static_cast<unsigned>(below)); }

    void doJob()
    {
        EncoderSession &encoder = *bus->encoder(draw(2) == 0 ? five : six);
        const std::array<Job, 3> wishes{
            ReadParameters{{Parameter::serialNumber}},
            WriteParameters{.values = {{Parameter::steps, 100 + draw(1'000)}}, .previous = {}},
            SetPreset{.value = 5}};
        if (encoder.start(wishes.at(static_cast<std::size_t>(draw(3)))))
            ++jobs.begun;
        else if (draw(2) == 0 && encoder.runningJob())
            encoder.cancel(OnCancel::leaveAsIs);
    }
    void doByHand()
    {
        using Kind = canopen::LssRequest::Kind;
        ++transfers.begun;
        bus->transfer({.node = 1 + draw(8), .object = {0x6200, 0}});
        ++services.begun;
        bus->configure({.kind = draw(2) == 0 ? Kind::inquireNode : Kind::operateAll});
        ++frames.begun;
        bus->send(test::canFrame(0, {static_cast<std::uint8_t>(draw(2) == 0 ? 0x01 : 0x80), 0}));
    }
    void doSomething()
    {
        switch (draw(9)) {
        case 0:
        case 1:
            return doJob();
        case 2:
            return doByHand();
        case 3:
            return draw(4) == 0 ? bus->alarmStop() : bus->setOperate(draw(3) != 0);
        case 4:
            return draw(2) == 0 ? bus->scan() : bus->cancelScan();
        case 5:
            link->isGone = draw(5) == 0;
            return;
        case 6:
            link->isFull = draw(4) == 0;
            return;
        case 7:
            return draw(6) == 0 ? bus->cancelConfiguration() : bus->setRunning(draw(4) != 0);
        default:
            say(test::canFrame(0x605, {0x40, 0x04, 0x60, 0, 0, 0, 0, 0}));
            return bus->sendBesideOthers();
        }
    }

    Count jobs;
    Count transfers;
    Count services;
    Count frames;

private:
    std::mt19937 m_random{GetParam()};
};

TEST_P(CanopenSoak, WhateverWasAskedEndsOnce)
{
    operate();
    for (const Place place : {five, six})
        QObject::connect(bus->encoder(place), &EncoderSession::finished, bus.get(), [this] { ++jobs.ended; });
    for (int i = 0; i < 300; ++i) {
        doSomething();
        bus->advance(std::chrono::milliseconds(draw(200)));
    }
    link->isGone = link->isFull = false;
    bus->advance(30s);
    EXPECT_EQ(bus->state(), BusState::open);
    EXPECT_GT(jobs.begun, 5);
    EXPECT_EQ(jobs.ended, jobs.begun);
    EXPECT_EQ(transfers.ended, transfers.begun);
    EXPECT_EQ(services.ended, services.begun);
    EXPECT_EQ(frames.ended, frames.begun);

    plant->bus()->setFaults({});
    bus->setRunning(true);
    bus->setOperate(true);
    bus->sendBesideOthers();
    bus->cancelScan();
    bus->advance(1s);
    bus->send(test::canFrame(0, {0x81, 0})); // whatever state they are in
    bus->advance(15s);
    const auto outcome = carryOut(six, ReadParameters{{Parameter::serialNumber}});
    EXPECT_TRUE(outcome && outcome->result);
}

INSTANTIATE_TEST_SUITE_P(Seeds, CanopenSoak, testing::Values(1U, 2U, 3U, 4U));

} // namespace
} // namespace codewheel
