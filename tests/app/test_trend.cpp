// SPDX-License-Identifier: GPL-3.0-or-later
// The trend in the window: how one gets there, and what stays.
#include "app/window/buses/plant.h"
#include "app/window/program.h"
#include "tests/app/window_test.h"
#include "widgets/cams/cam_editor.h"
#include "widgets/dial/dial_panel.h"
#include "widgets/look/label_text.h"
#include "widgets/models/dragged_place.h"
#include "widgets/settings/settings_dialog.h"
#include "widgets/structure/structure_view.h"
#include "widgets/trend/trend_chart.h"
#include "widgets/trend/trend_page.h"

#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QContextMenuEvent>
#include <QDropEvent>
#include <QMenu>
#include <QMimeData>
#include <QSpinBox>

#include <gmock/gmock.h>

namespace codewheel {
namespace {

using test::baumer;
using test::fraba;
using testing::ElementsAre;

class TrendInWindow : public test::WindowTest
{
protected:
    TrendPage &trend() { return *window().findChild<TrendPage *>(); }
    void choose(Place place) { window().findChild<StructureView *>()->choose(place); }
    std::vector<Track> curves()
    {
        std::vector<Track> curves;
        for (const TrendTracks::Shown &shown : trend().tracks().shown())
            curves.push_back(shown.track);
        return curves;
    }
    // The entry of the menu that opens at the widget.
    static void chooseInMenu(QWidget &widget, const QString &entry)
    {
        bool isFound = false;
        QTimer::singleShot(0, &widget, [&] {
            auto *menu = qobject_cast<QMenu *>(QApplication::activePopupWidget());
            ASSERT_NE(menu, nullptr);
            QAction *chosen = nullptr;
            for (QAction *action : menu->actions())
                if (plainLabel(action->text()) == entry)
                    chosen = action;
            menu->close();
            isFound = chosen != nullptr;
            if (chosen != nullptr)
                chosen->trigger();
        });
        QContextMenuEvent event(QContextMenuEvent::Mouse, widget.rect().center(),
                                widget.mapToGlobal(widget.rect().center()));
        QApplication::sendEvent(&widget, &event);
        QApplication::processEvents();
        EXPECT_TRUE(isFound) << entry.toStdString();
    }
};

TEST_F(TrendInWindow, IsOpenedByItsKey)
{
    QTest::keyClick(&window(), Qt::Key_F11);
    EXPECT_EQ(page(), &trend());
    QTest::keyClick(&window(), Qt::Key_Escape);
    EXPECT_NE(page(), &trend());
}

TEST_F(TrendInWindow, ShowsWhatIsChosenInTheBusStructure)
{
    choose(baumer);
    QTest::keyClick(&window(), Qt::Key_4, Qt::ControlModifier);
    EXPECT_EQ(page(), &trend());
    choose(placeOnLine({0x05}));
    actions().showInTrend->trigger();
    advance(1'000);
    EXPECT_THAT(curves(), ElementsAre(Track{baumer, Channel::position, {}},
                                      Track{placeOnLine({0x05}), Channel::position, {}}));
    for (const TrendLane &lane : trend().view().scene().lanes)
        EXPECT_TRUE(lane.curves.front().history->newest()) << lane.curves.front().name.toStdString();
    bus().close();
    advance(50);
    choose(baumer);
    EXPECT_FALSE(actions().showInTrend->isEnabled());
    EXPECT_EQ(curves().size(), 2U) << "what was kept can still be seen";
}

TEST_F(TrendInWindow, EveryValueLeadsThere)
{
    choose(fraba);
    advance(100);
    chooseInMenu(*window().findChild<DialPanel *>(), QStringLiteral("Show speed in trend"));
    EXPECT_EQ(page(), &trend());
    actions().monitors->trigger();
    const WordCard *card = monitors().card(fraba);
    ASSERT_NE(card, nullptr);
    for (QAction *action : card->actions())
        if (plainLabel(action->text()).contains(QStringLiteral("bit in trend")))
            action->trigger();
    EXPECT_EQ(page(), &trend());
    ASSERT_EQ(curves().size(), 2U);
    EXPECT_EQ(curves()[0], (Track{fraba, Channel::speed, {}}));
    EXPECT_EQ(curves()[1].place, fraba);
    EXPECT_TRUE(curves()[1].bit);
    window().showCams();
    Q_EMIT window().findChild<CamEditor *>()->trendWanted({fraba, Channel::cams, 3});
    EXPECT_EQ(curves().back(), (Track{fraba, Channel::cams, 3}));
}

TEST_F(TrendInWindow, AnEncoderIsDraggedIntoIt)
{
    actions().trend->trigger();
    EXPECT_FALSE(trend().view().chart().viewport()->acceptDrops()) << "so that it reaches the page";
    const auto data = draggedPlace(baumer, QStringLiteral("2.0"));
    QDragEnterEvent enter(QPoint(5, 5), Qt::CopyAction, data.get(), Qt::LeftButton, {});
    enter.ignore();
    QCoreApplication::sendEvent(&trend(), &enter);
    EXPECT_TRUE(enter.isAccepted());
    QDropEvent drop(QPointF(5, 5), Qt::CopyAction, data.get(), Qt::LeftButton, {});
    QCoreApplication::sendEvent(&trend(), &drop);
    EXPECT_THAT(curves(), ElementsAre(Track{baumer, Channel::position, {}}));
}

TEST_F(TrendInWindow, TheCurvesAreThereAtTheNextStart)
{
    choose(baumer);
    actions().showInTrend->trigger();
    trend().showTrack({fraba, Channel::out, 25});
    window().saveWindow();
    open();
    EXPECT_THAT(curves(), ElementsAre(Track{baumer, Channel::position, {}}, Track{fraba, Channel::out, 25}));
}

TEST_F(TrendInWindow, NothingIsSentHere)
{
    const Word before = out(fraba);
    choose(fraba);
    actions().showInTrend->trigger();
    trend().showTrack({fraba, Channel::out, 25});
    advance(2'000);
    EXPECT_EQ(out(fraba), before);
    EXPECT_EQ(bus().encoder(fraba)->eepromWrites(), 0);
}

} // namespace
} // namespace codewheel
