// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/places.h"
#include "tests/widgets/training_bus_session.h"
#include "widgets/kinds/interbus/training/fault_plan_bar.h"
#include "widgets/kinds/interbus/training/training_panel.h"
#include "widgets/look/inline_message.h"

#include <QCheckBox>
#include <QFile>
#include <QIODevice>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

class RingFaultsTest : public testing::Test
{
protected:
    RingFaultsTest()
    {
        panel.resize(280, 1'000);
        panel.show();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(&panel));
        QObject::connect(&panel, &TrainingPanel::acted, &panel,
                         [this](Place, const TrainingAct &what) { acts.push_back(trainingActText(what)); });
        QObject::connect(&panel, &TrainingPanel::planned, &panel,
                         [this](Place, const TrainingAct &what) { steps.push_back(trainingActText(what)); });
    }
    QCheckBox &box(const char *text) const
    {
        for (QCheckBox *each : panel.findChildren<QCheckBox *>())
            if (each->text() == QLatin1String(text))
                return *each;
        ADD_FAILURE() << "no " << text;
        std::abort();
    }
    QSpinBox &rate() const
    {
        for (QSpinBox *each : panel.findChildren<QSpinBox *>())
            if (each->accessibleName() == QStringLiteral("CRC errors of 1000 data cycles"))
                return *each;
        ADD_FAILURE() << "no rate";
        std::abort();
    }
    void tick(const char *text)
    {
        box(text).setFocus();
        QTest::keyClick(&box(text), Qt::Key_Space);
    }
    void frame(int cycles)
    {
        ring.bus.advance(cycles);
        panel.refresh();
    }
    QString file(const QByteArray &content)
    {
        QString path = folder.filePath(QStringLiteral("lesson.json"));
        QFile file(path);
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(content);
        return path;
    }

    QTemporaryDir folder;
    test::TrainingBusSession ring;
    TrainingPanel panel{ring.controls};
    QStringList acts;
    QStringList steps;
};

TEST_F(RingFaultsTest, ARateAboveTheMostIsRefusedWithASentence)
{
    panel.setDevice("4.0"_ring);
    const auto wrong = [this] {
        const auto labels = panel.findChildren<QLabel *>(QStringLiteral("wrongInput"));
        const auto told = std::ranges::find_if(labels, [](const QLabel *each) { return each->isVisible(); });
        return told == labels.end() ? QString() : (*told)->text();
    };
    EXPECT_EQ(wrong(), QString());
    rate().setFocus();
    rate().selectAll();
    QTest::keyClicks(&rate(), QStringLiteral("150"));
    QTest::keyClick(&rate(), Qt::Key_Tab);
    EXPECT_FALSE(rate().hasFocus());
    EXPECT_TRUE(wrong().contains(QStringLiteral("100"))) << wrong().toStdString();
    rate().setFocus();
    rate().selectAll();
    QTest::keyClicks(&rate(), QStringLiteral("15"));
    EXPECT_EQ(wrong(), QString());
}

TEST_F(RingFaultsTest, ABrokenWireStopsTheBusUntilItIsMended)
{
    panel.setDevice("4.0"_ring);
    tick("Wire break before it");
    frame(40);
    EXPECT_EQ(ring.bus.latest().state, MasterState::busFail);
    EXPECT_TRUE(box("Wire break before it").isChecked());
    EXPECT_EQ(acts.last(), QStringLiteral("4.0: Wire break before it"));
    tick("Wire break before it");
    frame(5);
    EXPECT_EQ(ring.bus.latest().state, MasterState::ready);
}

TEST_F(RingFaultsTest, OfEachPlaceOnlyWhatFitsIsShown)
{
    panel.setDevice(test::busTerminal);
    EXPECT_TRUE(box("Device without supply").isVisible());
    EXPECT_FALSE(box("Wrong device in place").isVisible());
    EXPECT_FALSE(box("Power on").isVisible());
    EXPECT_TRUE(rate().isVisible());
    panel.setDevice(test::onLoop);
    EXPECT_TRUE(box("Wrong device in place").isVisible());
    EXPECT_TRUE(box("Cam out of range").isVisible());
    EXPECT_TRUE(box("Power on").isVisible());
    panel.setDevice(test::singleTurn);
    EXPECT_FALSE(box("Cam out of range").isVisible());
}

TEST_F(RingFaultsTest, AFaultPlanIsLoadedRunAndTold)
{
    auto *bar = panel.findChild<FaultPlanBar *>();
    ASSERT_TRUE(bar->load(file(R"({"format": "codewheel-faults", "version": 1, "title": "Lesson 1", "steps": [
        {"at": 100, "fault": "peripheralFault", "place": "1.0"},
        {"at": 2100, "fault": "wireBreak", "place": "4.0"}]})")));
    QLabel *next = nullptr;
    for (QLabel *label : panel.findChildren<QLabel *>())
        if (label->accessibleName() == QStringLiteral("Fault plan"))
            next = label;
    ASSERT_NE(next, nullptr);
    EXPECT_EQ(next->text(), QStringLiteral("Lesson 1: 2 steps"));
    for (QPushButton *button : bar->findChildren<QPushButton *>())
        if (button->text() == QStringLiteral("Run"))
            QTest::mouseClick(button, Qt::LeftButton);
    frame(101);
    EXPECT_EQ(steps, QStringList{QStringLiteral("1.0: Peripheral fault")});
    EXPECT_EQ(next->text(), QStringLiteral("In 2.0 s: 4.0: Wire break before it"));
    frame(2'040);
    EXPECT_EQ(steps.size(), 2);
    EXPECT_EQ(ring.bus.latest().state, MasterState::busFail);
    EXPECT_EQ(next->text(), QStringLiteral("Lesson 1: 2 steps"));
}

TEST_F(RingFaultsTest, ABrokenPlanIsToldOnTheSpot)
{
    auto *bar = panel.findChild<FaultPlanBar *>();
    EXPECT_FALSE(bar->load(file("{\"format\": \"codewheel-faults\",\n\"version\": 2, \"steps\": []}")));
    EXPECT_TRUE(bar->findChild<InlineMessage *>()->isVisible());
    EXPECT_TRUE(bar->findChild<InlineMessage *>()->sentence().contains(QStringLiteral("line 2, version:")));
}

} // namespace
} // namespace codewheel
