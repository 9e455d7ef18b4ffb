// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/window/kinds/canopen/canopen_actions.h"
#include "app/window/kinds/esc/esc_line_actions.h"
#include "app/window/kinds/interbus/ring_actions.h"
#include "app/window/kinds/training_window.h"
#include "bus/word_channel.h"
#include "kinds/interbus/ring/ring_session.h"
#include "tests/support/places.h"
#include "widgets/monitor/monitor_area.h"
#include "widgets/monitor/word_card.h"

#include <QStackedWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include <gtest/gtest.h>

namespace codewheel::test {

inline constexpr Place fraba = "1.0"_ring;
inline constexpr Place baumer = "2.0"_ring;

// The panels are arranged for its size once its edge rests.
inline void waitUntilSettled(const MainWindow &window)
{
    const auto *settling = window.findChild<QTimer *>(QStringLiteral("settling"));
    EXPECT_TRUE(QTest::qWaitFor([&] { return !settling->isActive(); }));
}

// The whole window on the training bus in virtual time, shown and active.
class WindowTest : public testing::Test
{
protected:
    WindowTest() { open(); }

    void open()
    {
        shown.reset();
        shown = std::make_unique<TrainingWindow>(folder.filePath(QStringLiteral("window.ini")));
        window().show();
        window().activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&window()));
    }

    MainWindow &window() { return shown->window(); }
    RingSession &bus() { return shown->bus(); }
    const WindowActions &actions() { return window().actions(); }
    const RingActions &ringActions() { return *window().findChild<RingActions *>(); }
    const CanopenActions &canActions() { return *window().findChild<CanopenActions *>(); }
    const EscLineActions &lineActions() { return *window().findChild<EscLineActions *>(); }
    const QWidget *page() // that is open in the middle
    {
        return window().findChild<QStackedWidget *>(QStringLiteral("pages"))->currentWidget();
    }
    MonitorArea &monitors() { return *window().findChild<MonitorArea *>(); }
    void advance(int milliseconds) { shown->advance(milliseconds); }
    // At once, as a window manager does; then waits until the edge rests.
    void resizeTo(QSize size)
    {
        window().resize(size);
        waitUntilSettled(window());
        advance(50);
    }

    Word out(Place number) { return bus().channel(number)->out(); }
    Word in(Place number) { return bus().channel(number)->in(); }
    void send(Place number, Word word)
    {
        bus().channel(number)->stage(word);
        EXPECT_TRUE(bus().channel(number)->write());
        advance(10);
    }

    QTemporaryDir folder;
    std::unique_ptr<TrainingWindow> shown;
};

} // namespace codewheel::test
