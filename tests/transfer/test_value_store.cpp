// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/transfer/transfer_bus.h"
#include "transfer/project_places.h"
#include "transfer/value_store.h"

namespace codewheel {
namespace {

using test::baumer;
using test::fraba;

using ValueStore = test::TransferBus;

std::optional<StoredValue> find(const std::vector<StoredValue> &stored, Parameter parameter)
{
    const auto found = std::ranges::find(stored, parameter, &StoredValue::parameter);
    return found == stored.end() ? std::nullopt : std::optional(*found);
}

TEST_F(ValueStore, ReadsWhatCanBeReadAndKeepsItWithEvidenceAndTime)
{
    round.start({jobsToStore(encoder(fraba), false)}, JobRound::AfterRefusal::goOn);
    advance();
    const ProjectDevice device = withStored({}, encoder(fraba));
    const auto serial = find(device.stored, Parameter::serialNumber);
    ASSERT_TRUE(serial);
    EXPECT_EQ(serial->value, 20417);
    EXPECT_EQ(serial->evidence, Evidence::read);
    EXPECT_EQ(serial->at.timeSpec(), Qt::UTC);
    EXPECT_EQ(serial->at.toLocalTime().date(), QDate(2026, 3, 1));
    EXPECT_TRUE(find(device.stored, Parameter::steps));
    EXPECT_FALSE(find(device.stored, Parameter::temperature));
    EXPECT_TRUE(std::ranges::is_sorted(device.stored, {}, &StoredValue::parameter));
    EXPECT_TRUE(device.storedCams.empty());
    EXPECT_EQ(round.results()[0].outcomes.back().eepromWrites, 0);
}

TEST_F(ValueStore, OfAnEncoderThatCannotTellWhatItHasOnlyWhatIsKnown)
{
    encoder(baumer).tell(Parameter::coding, 6);
    EXPECT_TRUE(jobsToStore(encoder(baumer), true).jobs.empty());
    const ProjectDevice device = withStored({}, encoder(baumer));
    ASSERT_EQ(device.stored.size(), 1u);
    EXPECT_EQ(device.stored[0].evidence, Evidence::told);
}

TEST_F(ValueStore, WhatIsKnownNowGoesBeforeWhatWasStored)
{
    encoder(baumer).tell(Parameter::coding, 6);
    const QDateTime before = QDateTime(QDate(2026, 1, 1), QTime(0, 0), Qt::UTC);
    ProjectDevice device;
    device.stored = {{Parameter::steps, 4096, Evidence::echoed, before},
                     {Parameter::coding, 3, Evidence::echoed, before}};
    device = withStored(device, encoder(baumer));
    ASSERT_EQ(device.stored.size(), 2u);
    EXPECT_EQ(device.stored[0], (StoredValue{Parameter::steps, 4096, Evidence::echoed, before}));
    EXPECT_EQ(device.stored[1].value, 6);
    EXPECT_EQ(valuesStoredMessage({device}).arguments,
              (std::vector<RefusalArgument>{std::int64_t{1}, std::int64_t{2}}));
}

TEST_F(ValueStore, CamsAreReadOnlyIfAskedForAndTheModeIsAsBefore)
{
    round.start({jobsToStore(encoder(fraba), true)}, JobRound::AfterRefusal::goOn);
    advance(60'000);
    const ProjectDevice device = withStored({}, encoder(fraba));
    EXPECT_EQ(device.storedCams.size(), 8u);
    EXPECT_EQ(encoder(fraba).latest().mode, Mode::position);
}

TEST_F(ValueStore, StoredValuesComeBackToTheEncoder)
{
    ProjectDevice device;
    device.standAt(baumer);
    device.stored = {{Parameter::steps, 4096, Evidence::echoed, {}},
                     {Parameter::serialNumber, 4711, Evidence::told, {}}};
    const TransferWish wish = wishOf(device, TransferSource::stored, ProjectPlaces({}, buses), catalog);
    EXPECT_EQ(wish.values, (ParameterValues{{Parameter::steps, 4096}}));
}

} // namespace
} // namespace codewheel
