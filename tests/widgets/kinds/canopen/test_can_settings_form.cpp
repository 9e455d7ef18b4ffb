// SPDX-License-Identifier: GPL-3.0-or-later
#include "can/slcan_codec.h"
#include "kinds/canopen/plan/canopen_plan.h"
#include "widgets/connect/port_field.h"
#include "widgets/kinds/canopen/can_settings_form.h"
#include "widgets/look/inline_message.h"

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QTest>

#include <gtest/gtest.h>
#include <memory>
#include <stdexcept>

namespace codewheel {
namespace {

using Adapter = CanSettingsForm::Adapter;

KindData planOf(const char *link, int rate)
{
    return KindData(CanopenPlan{{.link = QString::fromLatin1(link), .rate = rate}});
}

CanInterfaceRows twoInterfaces()
{
    return {.rows = {{QStringLiteral("can0"), QStringLiteral("switched off"),
                      [](int rate) {
                          return Trouble(QStringLiteral("It is switched off."),
                                         QStringLiteral("switch on %1").arg(rate));
                      }},
                     {QStringLiteral("can1"), QStringLiteral("on, 250 kBit/s"), {}}},
            .none = {QStringLiteral("There is none."), QStringLiteral("ip link")}};
}

class CanSettingsFormTest : public testing::Test
{
protected:
    void make(Adapter adapter)
    {
        form = std::make_unique<CanSettingsForm>(adapter);
        form->makeFields();
        form->show();
    }
    CanopenSettings settings() const { return form->plan().as<CanopenPlan>()->settings; }
    QComboBox &rate() const { return *form->findChild<QComboBox *>(QStringLiteral("canRate")); }
    QComboBox &name() const
    {
        for (auto *box : form->findChildren<QComboBox *>())
            if (box->isEditable())
                return *box;
        throw std::logic_error("no interface");
    }
    InlineMessage &trouble() const { return *form->findChild<InlineMessage *>(); }

    std::unique_ptr<CanSettingsForm> form;
};

TEST_F(CanSettingsFormTest, AnInterfaceIsPlannedAsTheCommandLineNamesIt)
{
    make(Adapter::interface);
    form->setInterfaces(twoInterfaces());
    EXPECT_EQ(settings().link, QStringLiteral("can:can0")); // the first of the list
    name().setCurrentText(QStringLiteral("can1"));
    rate().setCurrentIndex(rate().findData(250'000));
    EXPECT_EQ(settings(), (CanopenSettings{QStringLiteral("can:can1"), 250'000}));
    EXPECT_EQ(rate().currentText(), QStringLiteral("250 kBit/s"));
    EXPECT_TRUE(form->wrong().isEmpty());
}

TEST_F(CanSettingsFormTest, WhatIsInTheWayIsShownWithTheCommandForTheRate)
{
    make(Adapter::interface);
    form->setInterfaces(twoInterfaces());
    EXPECT_EQ(trouble().sentence(), QStringLiteral("It is switched off."));
    EXPECT_EQ(trouble().command(), QStringLiteral("switch on 125000"));
    rate().setCurrentIndex(rate().findData(500'000));
    EXPECT_EQ(trouble().command(), QStringLiteral("switch on 500000"));
    EXPECT_EQ(form->findChild<QLabel *>(QStringLiteral("interfaceState"))->text(),
              QStringLiteral("switched off"));
    name().setCurrentText(QStringLiteral("can1"));
    EXPECT_FALSE(trouble().isVisibleTo(form.get()));
    form->setInterfaces({.rows = {}, .none = {QStringLiteral("There is none."), {}}});
    EXPECT_EQ(trouble().sentence(), QStringLiteral("There is none."));
    EXPECT_EQ(name().currentText(), QStringLiteral("can1")); // the choice stays
}

TEST_F(CanSettingsFormTest, ASerialAdapterHasTheRatesOfItsKind)
{
    make(Adapter::serial);
    form->setPorts({{QStringLiteral("/dev/ttyACM0"), QStringLiteral("CANable"), {}}});
    ASSERT_EQ(rate().count(), static_cast<int>(slcanRates.size()));
    for (int i = 0; i < rate().count(); ++i)
        EXPECT_EQ(rate().itemData(i).toInt(), slcanRates.at(static_cast<std::size_t>(i)));
    EXPECT_EQ(settings(), (CanopenSettings{QStringLiteral("slcan:/dev/ttyACM0"), 125'000}));
    form->findChild<QSpinBox *>(QStringLiteral("canBaudRate"))->setValue(57'600);
    EXPECT_EQ(settings().link, QStringLiteral("slcan:/dev/ttyACM0,baud=57600"));
}

TEST_F(CanSettingsFormTest, APlanIsShownByTheFormOfItsAdapterOnly)
{
    make(Adapter::serial);
    EXPECT_FALSE(form->showPlan(planOf("can:can0", 125'000)));
    EXPECT_FALSE(form->showPlan(planOf("", 125'000))); // the simulated bus
    EXPECT_FALSE(form->showPlan(KindData(1)));
    EXPECT_TRUE(form->showPlan(planOf("slcan:ttyACM1,baud=9600", 500'000)));
    EXPECT_EQ(settings(), (CanopenSettings{QStringLiteral("slcan:ttyACM1,baud=9600"), 500'000}));
    make(Adapter::interface);
    EXPECT_TRUE(form->showPlan(planOf("can:can7", 83'333)));
    EXPECT_EQ(settings(), (CanopenSettings{QStringLiteral("can:can7"), 83'333}));
    EXPECT_FALSE(form->showPlan(planOf("slcan:ttyACM1", 500'000)));
}

TEST_F(CanSettingsFormTest, WithoutFieldsItAnswersAsIfItShowedThePlan)
{
    form = std::make_unique<CanSettingsForm>(Adapter::interface);
    EXPECT_TRUE(form->showPlan(planOf("can:can7", 250'000)));
    EXPECT_EQ(settings(), (CanopenSettings{QStringLiteral("can:can7"), 250'000}));
    form->setInterfaces(twoInterfaces());
    form->makeFields();
    EXPECT_EQ(name().count(), 2);
    EXPECT_EQ(settings(), (CanopenSettings{QStringLiteral("can:can7"), 250'000}));
}

TEST_F(CanSettingsFormTest, WhatIsNoAdapterIsSaid)
{
    make(Adapter::interface);
    EXPECT_FALSE(form->wrong().isEmpty()); // nothing is given
    name().setCurrentText(QStringLiteral("a/b"));
    EXPECT_TRUE(form->wrong().contains(QStringLiteral("is no link to a CAN bus")));
    make(Adapter::serial);
    EXPECT_FALSE(form->wrong().isEmpty());
}

TEST_F(CanSettingsFormTest, EveryControlHasANameAndSaysWhatItIsFor)
{
    for (const Adapter adapter : {Adapter::interface, Adapter::serial}) {
        make(adapter);
        for (const auto *box : form->findChildren<QComboBox *>()) {
            EXPECT_FALSE(box->accessibleName().isEmpty());
            EXPECT_FALSE(box->toolTip().isEmpty());
        }
        for (const auto *box : form->findChildren<QSpinBox *>())
            EXPECT_FALSE(box->accessibleName().isEmpty() || box->toolTip().isEmpty());
    }
}

} // namespace
} // namespace codewheel
