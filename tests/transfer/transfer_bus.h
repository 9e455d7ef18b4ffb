// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/buses.h"
#include "catalog/catalog.h"
#include "kinds/interbus/ring/ring_session.h"
#include "kinds/interbus/simulator/training_bus.h"
#include "tests/support/places.h"
#include "transfer/transfer_account.h"
#include "vocabulary/hex.h"

#include <gtest/gtest.h>

namespace codewheel::test {

inline constexpr Place fraba = "1.0"_ring;
inline constexpr Place baumer = "2.0"_ring;
inline constexpr Place singleTurn = "3.0"_ring;
inline constexpr Place rod = "5.0"_ring;
inline constexpr Place onLoop = "6.1"_ring;

// The training bus in virtual time, and a round of jobs on it.
class TransferBus : public testing::Test
{
protected:
    explicit TransferBus(RingSession::Start start = RingSession::Start::operating);

    EncoderSession &encoder(Place number) { return *bus.encoder(number); }
    // Until the round ends, or `milliseconds` have passed.
    void advance(int milliseconds = 20'000);
    TransferAccount carryOut(const TransferPlan &plan,
                             JobRound::AfterRefusal afterRefusal = JobRound::AfterRefusal::goOn);
    // The words sent to the encoder so far, without 00000000: "02000FA0 80000000".
    QString words(Place number) const;

    const Catalog catalog = Catalog::builtIn();
    TrainingBus training = makeTrainingBus(catalog);
    RingSession bus{std::move(training.link), catalog, QDateTime(QDate(2026, 3, 1), QTime(14, 2))};
    Buses buses;
    JobRound round{buses};

private:
    std::map<Place, std::vector<Word>> m_words;
};

} // namespace codewheel::test
