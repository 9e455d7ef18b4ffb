// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/widgets/cams/cam_test.h"
#include "tests/widgets/training_bus_session.h"
#include "widgets/cams/cam_editor.h"
#include "widgets/cams/cam_review.h"
#include "widgets/cams/cam_shift_spin.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/label_text.h"

#include <QAbstractButton>
#include <QAction>
#include <QLatin1Char>
#include <QTest>

#include <gtest/gtest.h>

namespace codewheel::test {

// The cam editor with FRABA 1.0 of the training bus, in virtual time.
class CamEditorTest : public testing::Test
{
protected:
    CamEditorTest()
    {
        editor.resize(760, 520);
        editor.show();
        editor.activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&editor));
        editor.setEncoder(&encoder());
    }

    EncoderSession &encoder() { return ring.encoder(fraba); }
    CamSheet &sheet() { return *editor.findChild<CamSheet *>(); }
    const CamProgram &program(unsigned number) { return sheet().document().program(number); }
    void setManualCam() { sheet().setCam(manualCam, manualValue, {}); }

    // 8192 steps per turn, in position mode: told, so that nothing is sent.
    void tellAll()
    {
        encoder().tell(Parameter::startUpMode, 1);
        encoder().tell(Parameter::steps, 8192);
        encoder().tell(Parameter::revolutions, 1);
        encoder().tell(Parameter::direction, 3);
        advance(40);
    }
    void advance(int milliseconds)
    {
        for (; milliseconds > 0; milliseconds -= 20)
            ring.bus.advance(20);
    }
    // At most 20 s of bus time.
    void finishJob()
    {
        for (int i = 0; i < 1000 && encoder().runningJob(); ++i)
            ring.bus.advance(20);
        ASSERT_FALSE(encoder().runningJob());
        advance(60);
    }
    Word out() { return ring.channel(fraba).out(); }
    QString message() const
    {
        const auto *shown = editor.findChild<InlineMessage *>();
        return shown->isVisible() ? shown->sentence() : QString();
    }
    QAction &action(const char *text)
    {
        for (QAction *each : editor.findChildren<QAction *>())
            if (plainLabel(each->text()) == QString::fromUtf8(text))
                return *each;
        ADD_FAILURE() << "no " << text;
        std::abort();
    }
    void trigger(const char *text)
    {
        ASSERT_TRUE(action(text).isEnabled()) << text;
        action(text).trigger();
    }
    QAbstractButton *button(const char *name)
    {
        auto *found = editor.findChild<QAbstractButton *>(QLatin1String(name));
        return found != nullptr && found->isVisible() ? found : nullptr;
    }
    void click(const char *name)
    {
        ASSERT_NE(button(name), nullptr) << name;
        QTest::mouseClick(button(name), Qt::LeftButton);
    }

    CamReview &review() { return *editor.findChild<CamReview *>(); }
    QStringList reviewed(CamReview::Column column)
    {
        QStringList texts;
        const auto &model = *review().findChild<ReviewTable *>();
        for (int row = 0; row < model.rowCount(); ++row)
            texts << model.index(row, column).data().toString();
        return texts;
    }

    TrainingBusSession ring;
    ProjectDocument project;
    CamEditor editor{ring.buses, ring.catalog, project};
};

} // namespace codewheel::test
