// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/widgets/training_bus_session.h"
#include "widgets/look/inline_message.h"
#include "widgets/trend/trend_chart.h"
#include "widgets/trend/trend_page.h"

#include <QTableView>
#include <QTest>
#include <QWheelEvent>

#include <gmock/gmock.h>

namespace codewheel::test {

using namespace std::chrono_literals;

// On the training ring in virtual time: 2.0 turns, 1.0 stands.
class TrendPageTest : public testing::Test
{
protected:
    TrendPageTest()
    {
        page.resize(700, 600);
        page.show();
        page.activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&page));
        ring.controls->setSpeed(baumer.node, 60);
        for (const auto &[parameter, value] :
             {std::pair(Parameter::steps, 8'192), {Parameter::revolutions, 1}, {Parameter::coding, 3}})
            ring.encoder(baumer).tell(parameter, value);
        for (const auto &[parameter, value] :
             {std::pair(Parameter::startUpMode, 1), {Parameter::steps, 8'192}, {Parameter::revolutions, 1}})
            ring.encoder(fraba).tell(parameter, value);
    }
    void advance(Instant duration)
    {
        for (Instant passed{}; passed < duration; passed += 33ms) {
            ring.bus.advance(33ms);
            page.showFrame();
        }
        QCoreApplication::processEvents();
    }
    template <class Widget>
    Widget &find(const char *name)
    {
        return *page.findChild<Widget *>(QLatin1String(name));
    }
    TrendView &view() { return page.view(); }
    TrendChart &chart() { return page.view().chart(); }
    TimeSpan seen() { return view().scene().span; }
    const TrendLane &lane(std::size_t index) { return view().scene().lanes.at(index); }
    QString cell(int row, int column)
    {
        return find<QTableView>("trendTable").model()->index(row, column).data().toString().trimmed();
    }
    static double number(QString text) { return QLocale().toDouble(text.remove(u'+').section(u' ', 0, 0)); }
    QPoint at(double x, double y) // parts of the plot
    {
        const QRectF plot = chart().plot();
        return QPointF(plot.left() + x * plot.width(), plot.top() + y * plot.height()).toPoint();
    }
    void click(double x, Qt::KeyboardModifiers modifiers = {})
    {
        QTest::mouseClick(chart().viewport(), Qt::LeftButton, modifiers, at(x, 0.5));
    }
    void drag(QPoint from, QPoint to, Qt::MouseButton button = Qt::LeftButton)
    {
        QTest::mousePress(chart().viewport(), button, {}, from);
        QTest::mouseMove(chart().viewport(), (from + to) / 2);
        QTest::mouseMove(chart().viewport(), to);
        QTest::mouseRelease(chart().viewport(), button, {}, to);
    }
    void wheel(double x, int notches, Qt::KeyboardModifiers modifiers = {})
    {
        QWheelEvent event(at(x, 0.5), chart().viewport()->mapToGlobal(at(x, 0.5)), {}, {0, 120 * notches},
                          Qt::NoButton, modifiers, Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(chart().viewport(), &event);
    }
    void press(Qt::Key key, Qt::KeyboardModifiers modifiers = {})
    {
        chart().setFocus();
        QTest::keyClick(&chart(), key, modifiers);
    }
    QString sentence() { return page.findChild<InlineMessage *>()->sentence(); }

    test::TrainingBusSession ring;
    Histories histories{ring.buses};
    TrendPage page{ring.buses, histories,
                   [](Place place) { return place == fraba ? QStringLiteral("Hoist") : QString(); }};
};

} // namespace codewheel::test
