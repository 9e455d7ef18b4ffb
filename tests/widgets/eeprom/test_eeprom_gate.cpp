// SPDX-License-Identifier: GPL-3.0-or-later
// A FRABA of the training bus whose ledger says that it was written to often: every place that starts a job.
#include "tests/widgets/training_bus_session.h"
#include "widgets/eeprom/eeprom_gate.h"
#include "widgets/eeprom/eeprom_question.h"
#include "widgets/parameters/write_review.h"

namespace codewheel {
namespace {

using test::baumer;
using test::fraba;

class EepromGateTest : public testing::Test
{
protected:
    void count(int writes, DeviceNumber place = fraba)
    {
        ring.encoder(place).setEepromCount(
            {.writes = writes, .since = QDateTime(QDate(2026, 3, 1), QTime(12, 0)), .by = CountedBy::place});
    }
    template <typename Widget>
    static Widget &find(QWidget &parent, const char *name)
    {
        auto *found = parent.findChild<Widget *>(QString::fromLatin1(name));
        if (found == nullptr)
            std::abort();
        return *found;
    }

    test::TrainingBusSession ring;
};

TEST_F(EepromGateTest, SaysByWhatItIsCountedAndAsksNothing)
{
    EepromGate gate;
    count(12);
    gate.setWrites(ring.encoder(fraba), 4);
    EXPECT_TRUE(gate.isOpen());
    EXPECT_EQ(
        find<QLabel>(gate, "eepromCount").text(),
        QStringLiteral("EEPROM writes by this program since 1 Mar 2026: 12, counted by its place, since the "
                       "serial number is not known."));
    EXPECT_FALSE(find<QLabel>(gate, "eepromConcern").isVisibleTo(&gate));
    EXPECT_FALSE(find<QCheckBox>(gate, "writeNevertheless").isVisibleTo(&gate));
}

TEST_F(EepromGateTest, WarnsFromThreeQuartersOn)
{
    EepromGate gate;
    count(150);
    gate.setWrites(ring.encoder(fraba), 1);
    EXPECT_TRUE(gate.isOpen());
    EXPECT_TRUE(find<QLabel>(gate, "eepromConcern").isVisibleTo(&gate));
}

TEST_F(EepromGateTest, HasToBeTickedBeyondTheBudget)
{
    EepromGate gate;
    count(200);
    gate.setWrites(ring.encoder(fraba), 1);
    EXPECT_FALSE(gate.isOpen());
    find<QCheckBox>(gate, "writeNevertheless").click();
    EXPECT_TRUE(gate.isOpen());
    gate.setWrites(ring.encoder(fraba), 2);
    EXPECT_TRUE(gate.isOpen()); // the same concern
    count(500);
    EXPECT_FALSE(gate.isOpen()); // another one
}

TEST_F(EepromGateTest, WantsThePlaceBeyondTheLimit)
{
    EepromGate gate;
    QSignalSpy changes(&gate, &EepromGate::changed);
    count(500);
    gate.setWrites(ring.encoder(fraba), 1);
    auto &place = find<QLineEdit>(gate, "typedPlace");
    QTest::keyClicks(&place, QStringLiteral("1."));
    EXPECT_FALSE(gate.isOpen());
    QTest::keyClicks(&place, QStringLiteral("0"));
    EXPECT_TRUE(gate.isOpen());
    EXPECT_EQ(changes.size(), 3);
}

TEST_F(EepromGateTest, AsksNothingWhereTheManualIsSilent)
{
    EepromGate gate;
    count(10'000, baumer);
    gate.setWrites(ring.encoder(baumer), 4);
    EXPECT_TRUE(gate.isOpen());
    EXPECT_TRUE(find<QLabel>(gate, "eepromCount").isVisibleTo(&gate));
}

TEST_F(EepromGateTest, HoldsBackTheReviewOfParameters)
{
    WriteReview review;
    count(200);
    review.review(ring.encoder(fraba), {{Parameter::steps, 255}});
    auto &write = find<QPushButton>(review, "confirmWrite");
    EXPECT_FALSE(write.isEnabled());
    find<QCheckBox>(review, "writeNevertheless").click();
    EXPECT_TRUE(write.isEnabled());
}

TEST_F(EepromGateTest, AQuestionIsAskedOnlyWhereThereIsOne)
{
    QWidget window;
    count(100);
    EXPECT_TRUE(askForEeprom(&window, ring.encoder(fraba), SetPreset{}));
    count(500);
    EXPECT_TRUE(askForEeprom(&window, ring.encoder(fraba), ReadParameters{{Parameter::steps}}));
    bool wasAsked = false;
    QTimer::singleShot(0, &window, [&] {
        auto *dialog = qobject_cast<QDialog *>(QApplication::activeModalWidget());
        ASSERT_NE(dialog, nullptr);
        wasAsked = true;
        EXPECT_FALSE(find<QPushButton>(*dialog, "writeToEeprom").isEnabled());
        QTest::keyClicks(&find<QLineEdit>(*dialog, "typedPlace"), QStringLiteral("1.0"));
        find<QPushButton>(*dialog, "writeToEeprom").click();
    });
    EXPECT_TRUE(askForEeprom(&window, ring.encoder(fraba), SetPreset{}));
    EXPECT_TRUE(wasAsked);
    QTimer::singleShot(0, &window, [] { QApplication::activeModalWidget()->close(); });
    EXPECT_FALSE(askForEeprom(&window, ring.encoder(fraba), SetPreset{}));
}

} // namespace
} // namespace codewheel
