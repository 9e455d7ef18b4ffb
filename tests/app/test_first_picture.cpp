// SPDX-License-Identifier: GPL-3.0-or-later
// What a user sees at the first start: all positions, although nothing was sent to get them.
#include "tests/app/window_test.h"
#include "tests/support/painted_texts.h"
#include "widgets/dial/code_disc.h"
#include "widgets/dial/dial_panel.h"
#include "widgets/parameters/parameter_model.h"
#include "widgets/parameters/parameter_table.h"
#include "widgets/structure/structure_view.h"

#include <algorithm>

namespace codewheel {
namespace {

using FirstPicture = test::WindowTest;

const EncoderSession &encoderOf(const RingSession &bus, Place place)
{
    return *bus.encoder(place);
}

TEST_F(FirstPicture, EveryEncoderShowsItsPosition)
{
    advance(100);
    int encoders = 0;
    for (const Place place : bus().places()) {
        EXPECT_EQ(out(place), 0U) << place.shown().toStdString();
        if (bus().encoder(place) == nullptr)
            continue;
        ++encoders;
        EXPECT_TRUE(encoderOf(bus(), place).showsPosition()) << place.shown().toStdString();
        EXPECT_EQ(encoderOf(bus(), place).eepromWrites(), 0);
    }
    EXPECT_EQ(encoders, 6);
}

TEST_F(FirstPicture, TheFirstIsChosenWithItsMonitorAndItsDialHasAScale)
{
    advance(100);
    EXPECT_NE(monitors().card(test::fraba), nullptr);
    const auto &shown = window().findChild<DialPanel *>()->findChild<CodeDisc *>()->state();
    EXPECT_EQ(shown.position, 12'345);
    EXPECT_TRUE(shown.turnFraction);
    EXPECT_EQ(shown.turn, 1);
    EXPECT_TRUE(shown.note.isEmpty()) << shown.note.toStdString();
}

TEST_F(FirstPicture, WhatTheMakersOfThePlantKnowIsToldNotRead)
{
    for (const Place place : bus().places()) {
        const EncoderSession *encoder = bus().encoder(place);
        if (encoder == nullptr)
            continue;
        for (const ParameterDescription &parameter : encoder->device().parameters)
            if (const auto known = encoder->known(parameter.parameter)) {
                EXPECT_EQ(known->evidence, Evidence::told) << place.shown().toStdString();
            }
    }
    EXPECT_TRUE(encoderOf(bus(), test::fraba).known(Parameter::steps));
    EXPECT_TRUE(encoderOf(bus(), test::baumer).known(Parameter::coding));
}

TEST_F(FirstPicture, WhatTheyKnowIsTrue)
{
    EncoderSession &encoder = *bus().encoder(test::fraba);
    const std::vector<Parameter> asked{Parameter::steps, Parameter::revolutions, Parameter::direction};
    ParameterValues told;
    for (const Parameter parameter : asked)
        told.push_back({parameter, encoder.known(parameter)->value});
    ASSERT_TRUE(encoder.start(ReadParameters{asked}));
    advance(2000);
    for (const ParameterValue &value : told) {
        const auto known = encoder.known(value.parameter);
        EXPECT_EQ(known->evidence, Evidence::read);
        EXPECT_EQ(known->value, value.value);
    }
    const auto shafts = shown->controls().shafts();
    const auto baumer =
        std::ranges::find(shafts, test::baumer.node, &TrainingControls::Shaft::number); // cannot be read
    ASSERT_NE(baumer, shafts.end());
    EXPECT_NEAR(static_cast<double>(*encoderOf(bus(), test::baumer).latest().position),
                static_cast<double>(baumer->raw), 100);
}

TEST_F(FirstPicture, AKnownValueThatTakesTwoColumnsBeginsBelowItsHeading)
{
    resizeTo({1280, 800});
    window().findChild<StructureView *>()->choose(test::fraba);
    auto *table = window().findChild<ParameterTable *>();
    table->scrollToBottom();
    advance(50);
    bool isSeen = false;
    for (const test::PaintedText &painted : test::paintedTexts(*table->viewport()))
        if (painted.text.contains(QStringLiteral("position, as"))) {
            isSeen = true;
            EXPECT_LT(painted.ink.left(), table->columnViewportPosition(ParameterModel::wantedColumn) - 20);
        }
    EXPECT_TRUE(isSeen);
}

} // namespace
} // namespace codewheel
