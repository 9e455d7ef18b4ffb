// SPDX-License-Identifier: GPL-3.0-or-later
// What is simulated begins anew by one command: of the panel Training, or of the menu.
#include "tests/app/kinds/interbus/offer_test.h"
#include "tests/support/register_bank.h"
#include "widgets/kinds/esc/training/esc_line_training_panel.h"
#include "widgets/kinds/interbus/training/training_panel.h"
#include "widgets/structure/structure_view.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QTranslator>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using test::baumer;
using test::fraba;
using test::ModbusClient;
using test::partOf;

constexpr std::int64_t firstRaw = 12'345;     // as the plan of the training bus has it
constexpr EscLineAddress encoderAtRest{0x05}; // at 1235h, likewise

QPushButton &afreshButton(const QWidget &panel)
{
    return partOf<QPushButton>(panel, "startAfresh");
}

class StartAfresh : public test::OfferTest
{
protected:
    StartAfresh()
    {
        window().findChild<QDockWidget *>(QStringLiteral("trainingDock"))->raise();
        showFrame();
    }

    void showFrame() { window().showFrame(); }
    const TrainingPanel &panel() { return *window().findChild<TrainingPanel *>(); }
    static QString chosenIn(const QWidget &panel)
    {
        for (const auto *field : panel.findChildren<QComboBox *>())
            if (field->accessibleName() == QStringLiteral("Device to train with"))
                return field->currentText();
        return {};
    }
    TrainingControls::Shaft shaft(Place place)
    {
        for (const TrainingControls::Shaft &its : shown->controls().shafts())
            if (its.number == place.node)
                return its;
        ADD_FAILURE() << "no shaft";
        return {};
    }
    // The new ring begins, driven by a thread as before.
    void goOn()
    {
        bus().startThread(std::chrono::milliseconds(1));
        EXPECT_TRUE(waitFor([&] { return bus().isRunning(); }));
    }
    bool sent(Place place, Word word)
    {
        bus().channel(place)->stage(word);
        return bus().channel(place)->write() && waitFor([&] { return out(place) == word; });
    }
};

TEST_F(StartAfresh, EverythingIsAsAtTheStart)
{
    TrainingControls &before = shown->controls();
    before.setSpeed(fraba.node, 60);
    before.setFault(TrainingFault::powerOff, baumer.node, 1);
    before.setFault(TrainingFault::wireBreak, NodeId("4.0"), 1);
    before.startFaultPlan({{}, {{std::chrono::hours(1), TrainingFault::noSupply, NodeId("2.0"), 1}}});
    EXPECT_TRUE(waitFor([&] { return !bus().isRunning(); }));
    EXPECT_NE(shaft(fraba).raw, firstRaw);

    window().findChild<StructureView *>()->choose(baumer);
    showFrame();
    QTest::mouseClick(&afreshButton(panel()), Qt::LeftButton);
    goOn();
    EXPECT_EQ(shaft(fraba).raw, firstRaw);
    EXPECT_EQ(shaft(fraba).revolutionsPerMinute, 0);
    EXPECT_TRUE(shaft(baumer).powered);
    EXPECT_EQ(shown->controls().planProgress().plan, nullptr);
    EXPECT_TRUE(bus().isOperating());
    EXPECT_TRUE(isSaid(QStringLiteral("Started afresh")));
    EXPECT_EQ(chosenIn(panel()), QStringLiteral("2.0"));
}

TEST_F(StartAfresh, WhatWasStoredAndKnownIsForgotten)
{
    const auto position = bus().encoder(fraba)->latest().position;
    ASSERT_TRUE(position);
    ASSERT_TRUE(sent(fraba, 0x0200'00FF)); // 255 steps per revolution
    EXPECT_TRUE(waitFor([&] { return in(fraba) == 0xC200'00FFu; }));
    ASSERT_TRUE(sent(fraba, 0x8000'0000)); // run stores them
    EXPECT_TRUE(waitFor([&] { return shaft(fraba).eepromWrites == 1; }));
    bus().encoder(fraba)->tell(Parameter::steps, 255);
    bus().encoder(baumer)->tell(Parameter::steps, 100);
    ringActions().afresh->trigger();
    goOn();
    EXPECT_EQ(shaft(fraba).eepromWrites, 0);
    EXPECT_EQ(out(fraba), 0u);
    EXPECT_EQ(bus().encoder(fraba)->known(Parameter::steps)->value, 8'192)
        << "as the plan of the training bus tells";
    EXPECT_EQ(bus().encoder(baumer)->known(Parameter::steps)->value, 8'192);
    EXPECT_TRUE(waitFor([&] { return bus().encoder(fraba)->latest().position == position; }));
}

// Another ring in between does not change them.
TEST_F(StartAfresh, WhatIsKnownAndCountedStaysWhileAnotherRingIsConnected)
{
    ASSERT_TRUE(
        bus().encoder(fraba)->start(WriteParameters{.values = {{Parameter::steps, 300}}, .previous = {}}));
    EXPECT_TRUE(waitFor([&] { return !bus().encoder(fraba)->runningJob(); }));
    const int writes = bus().encoder(fraba)->eepromCount().writes;
    ASSERT_GT(writes, 0);
    ringActions().disconnectBus->trigger();
    shown->project().setProject({}, {});
    shown->plant().first<RingAtWork>()->openTraining();
    goOn();
    EXPECT_EQ(bus().encoder(fraba)->known(Parameter::steps)->value, 300);
    EXPECT_EQ(bus().encoder(fraba)->eepromCount().writes, writes);
}

TEST_F(StartAfresh, WhatWasTypedBeforeALeaveDoesNotComeBack)
{
    bus().encoder(baumer)->tell(Parameter::steps, 100);
    ringActions().disconnectBus->trigger();
    ringActions().connectBus->trigger();
    ASSERT_EQ(bus().encoder(baumer)->known(Parameter::steps)->value, 100);
    ringActions().afresh->trigger();
    EXPECT_EQ(bus().encoder(baumer)->known(Parameter::steps)->value, 8'192);
}

TEST_F(StartAfresh, ThePanelTurnsToTheNewRing)
{
    ringActions().afresh->trigger();
    goOn();
    window().findChild<StructureView *>()->choose(fraba);
    showFrame();
    for (auto *box : panel().findChildren<QCheckBox *>())
        if (box->text() == QStringLiteral("Power on"))
            box->click();
    EXPECT_TRUE(waitFor([&] { return !shaft(fraba).powered; }));
}

// As in a window of another language.
class UpperCase final : public QTranslator
{
public:
    bool isEmpty() const override { return false; }
    QString translate(const char *, const char *source, const char *, int) const override
    {
        return QString::fromUtf8(source).toUpper();
    }
};

TEST_F(StartAfresh, WhatWasDoneIsToldInTheLanguageOfWhoeverReadsIt)
{
    {
        UpperCase otherLanguage;
        QCoreApplication::installTranslator(&otherLanguage);
        window().findChild<StructureView *>()->choose(fraba);
        showFrame();
        for (auto *box : panel().findChildren<QCheckBox *>())
            if (box->text() == QStringLiteral("Power on"))
                box->click();
        ringActions().afresh->trigger();
        EXPECT_TRUE(isSaid(QStringLiteral("POWER OFF.")));
    }
    goOn();
    EXPECT_TRUE(isSaid(QStringLiteral("Power off.")));
    EXPECT_TRUE(isSaid(QStringLiteral("Started afresh")));
}

TEST_F(StartAfresh, TheModeStays)
{
    bus().setOperate(false);
    EXPECT_TRUE(waitFor([&] { return !bus().isOperating(); }));
    ringActions().afresh->trigger();
    goOn();
    EXPECT_FALSE(bus().isOperating());
}

TEST_F(StartAfresh, NotWhileAJobRuns)
{
    shown->controls().setFault(TrainingFault::slowConfirmation, fraba.node, 1);
    ASSERT_TRUE(
        bus().encoder(fraba)->start(WriteParameters{.values = {{Parameter::steps, 255}}, .previous = {}}));
    EXPECT_TRUE(waitFor([&] { return !ringActions().afresh->isEnabled(); }));
    EXPECT_FALSE(afreshButton(panel()).isEnabled());
    EXPECT_TRUE(ringActions().afresh->toolTip().contains(QStringLiteral("job is running at 1.0")))
        << ringActions().afresh->toolTip().toStdString();
    EXPECT_EQ(afreshButton(panel()).toolTip().section(QStringLiteral(" ("), 0, 0),
              ringActions().afresh->toolTip().section(QStringLiteral(" ("), 0, 0));
}

TEST_F(StartAfresh, OnlyWhatIsSimulatedAndConnected)
{
    ASSERT_TRUE(ringActions().afresh->isEnabled());
    ringActions().disconnectBus->trigger();
    showFrame();
    EXPECT_FALSE(ringActions().afresh->isEnabled());
    EXPECT_TRUE(ringActions().afresh->toolTip().startsWith(QStringLiteral("It is not connected.")));
    planGateway();
    auto gateway = std::make_shared<test::RegisterBank>();
    ring().setPorts(
        [&](const GatewaySettings &) { return std::make_unique<test::RegisterBankPort>(gateway); });
    ringActions().connectBus->trigger();
    ASSERT_TRUE(bus().isOpen() && !bus().isSimulated());
    showFrame();
    EXPECT_FALSE(ringActions().afresh->isEnabled());
    EXPECT_TRUE(ringActions().afresh->toolTip().startsWith(QStringLiteral("It is real")));
}

TEST_F(StartAfresh, ItsClientsGoOnWithTheNewRing)
{
    offer();
    ModbusClient client(port());
    ASSERT_EQ(client.write(0, {0x0200, 0x00FF}), 0);
    ringActions().afresh->trigger();
    goOn();
    EXPECT_TRUE(ring().offer().isOn());
    EXPECT_TRUE(waitFor([&] { return client.readHolding(0, 2) == std::vector<std::uint16_t>{0, 0}; }));
    EXPECT_EQ(client.write(0, {0, 7}), 0);
    EXPECT_TRUE(waitFor([&] { return out(fraba) == 7u; }));
}

TEST_F(StartAfresh, ARingThatGetsOtherDevicesBackIsNoLongerOffered)
{
    shown->controls().setFault(TrainingFault::wireBreak, NodeId("6.0"), 1);
    EXPECT_TRUE(waitFor([&] { return !bus().isRunning(); }));
    ringActions().readIn->trigger();
    EXPECT_TRUE(waitFor([&] { return bus().structure().size() == 5U && bus().isRunning(); }));
    offer();
    ModbusClient client(port());
    ASSERT_EQ(client.readHolding(0, 2).size(), 2U);
    ringActions().afresh->trigger();
    EXPECT_FALSE(ring().offer().isOn());
    EXPECT_TRUE(client.readHolding(0, 2).empty());
    EXPECT_TRUE(isSaid(QStringLiteral("The ring has other devices now")));
}

TEST_F(StartAfresh, TheTrainingLineToo)
{
    const Place place{firstLine, encoderAtRest.node()};
    const auto rawPosition = [&] {
        std::int64_t raw = -1;
        shown->line().training()->withEncoder(
            encoderAtRest, [&](const SimulatedEscEncoder &its) { raw = its.shaft().raw(); });
        return raw;
    };
    const std::int64_t atFirst = rawPosition();
    shown->line().training()->setFaults({.lost = 100});
    shown->line().training()->withEncoder(encoderAtRest,
                                          [](SimulatedEscEncoder &its) { its.shaft().turnBy(500); });
    shown->line().session()->setOperate(false);
    advance(500);
    ASSERT_NE(rawPosition(), atFirst);
    window().findChild<StructureView *>()->choose(place);
    advance(50);
    lineActions().afresh->trigger();
    advance(500);
    EXPECT_EQ(rawPosition(), atFirst);
    EXPECT_EQ(shown->line().training()->faults().lost, 0);
    EXPECT_FALSE(shown->line().session()->isOperating());
    EXPECT_TRUE(shown->line().session()->isOpen());
    const auto &panel = *window().findChild<EscLineTrainingPanel *>();
    EXPECT_EQ(chosenIn(panel), place.toString());
    EXPECT_TRUE(afreshButton(panel).isEnabled());
    lineActions().disconnectBus->trigger();
    advance(50);
    EXPECT_FALSE(lineActions().afresh->isEnabled());
}

} // namespace
} // namespace codewheel
