// SPDX-License-Identifier: GPL-3.0-or-later
// A replaced encoder gets the values of the project in few clicks, in the smallest window, where everything
// to click is visible without scrolling.
#include "language.h"
#include "tests/app/window_test.h"
#include "widgets/look/inline_message.h"
#include "widgets/structure/structure_view.h"
#include "widgets/transfer/replace_page.h"

#include <QAction>
#include <QLocale>
#include <QPushButton>
#include <QToolBar>
#include <QTreeView>

namespace codewheel {
namespace {

constexpr Place replacedPlace = test::fraba;

class ReplacingByHand : public test::WindowTest, public testing::WithParamInterface<const char *>
{
protected:
    ReplacingByHand()
    {
        language.use(QString::fromLatin1(GetParam()));
        open();
        window().resize(1024, 640);
        actions().defaultLayout->trigger(); // the one for a low window
        window().resize(1024, 640);
        shown->project().editDevice(replacedPlace, QStringLiteral("plan"), [](ProjectDevice &device) {
            device.wanted = {{Parameter::steps, 4096}, {Parameter::revolutions, 1}};
        });
        advance(500);
    }
    ~ReplacingByHand() override { QLocale::setDefault(QLocale::c()); }

    // Swaps the encoder for another one.
    void exchange()
    {
        bus().encoder(replacedPlace)->tell(Parameter::steps, 4096); // as the new one is to have
        advance(50);
        shown->controls().setFault(TrainingFault::powerOff, replacedPlace.node, 1);
        advance(2000);
        shown->controls().turnBy(replacedPlace.node, 1'000); // of another encoder
        shown->controls().setFault(TrainingFault::powerOff, replacedPlace.node, 0);
        advance(500);
    }
    void click(QWidget &widget, QRect part)
    {
        ASSERT_TRUE(widget.isVisible() && widget.isEnabled());
        ASSERT_EQ(widget.visibleRegion().intersected(part), QRegion(part)) << "it is not in sight";
        QTest::mouseClick(&widget, Qt::LeftButton, {}, part.center());
        ++clicks;
        advance(50);
    }
    void clickDevice()
    {
        auto &tree = *window().findChild<StructureView *>()->findChild<QTreeView *>();
        const QModelIndex ring = tree.model()->index(0, 0);
        for (int row = 0; row < tree.model()->rowCount(ring); ++row) {
            const QModelIndex device = tree.model()->index(row, 0, ring);
            if (device.data().toString().startsWith(replacedPlace.toString())) {
                click(*tree.viewport(), tree.visualRect(device).intersected(tree.viewport()->rect()));
                return;
            }
        }
        FAIL() << "no row";
    }
    void clickReplace()
    {
        QWidget *button = window()
                              .findChild<QToolBar *>(QStringLiteral("busToolBar"))
                              ->widgetForAction(actions().replaceEncoder);
        click(*button, button->rect());
    }
    void clickNext()
    {
        auto &next = *window().findChild<QPushButton *>(QStringLiteral("replaceNext"));
        click(next, next.rect());
    }

    void clickNotice()
    {
        for (auto *button : window()
                                .findChild<InlineMessage *>(QStringLiteral("replaceNotice"))
                                ->findChildren<QPushButton *>())
            if (button->isVisible())
                return click(*button, button->rect());
        FAIL() << "no button";
    }
    void finish()
    {
        const auto &replacing = *window().findChild<ReplacePage *>();
        for (int i = 0; i < 200 && replacing.isBusy(); ++i)
            advance(50);
        ASSERT_FALSE(replacing.isBusy());
        EXPECT_EQ(replacing.title().right(3), QStringLiteral("4/4"));
        clickNext(); // Close
        EXPECT_EQ(page(), &monitors());
        EXPECT_EQ(bus().encoder(replacedPlace)->known(Parameter::steps)->value, 4096);
        EXPECT_EQ(bus().encoder(replacedPlace)->known(Parameter::revolutions)->value, 1);
    }

    Language language;
    int clicks = 0;
};

TEST_P(ReplacingByHand, TakesSixClicks)
{
    exchange();
    clickDevice();
    clickReplace();
    clickNext(); // the same make
    clickNext(); // the position before the swap
    clickNext(); // Write
    finish();
    EXPECT_EQ(clicks, 6);
}

TEST_P(ReplacingByHand, TakesEightClicksFromTheStartPage)
{
    ringActions().disconnectBus->trigger();
    lineActions().disconnectBus->trigger();
    advance(5);
    auto &replace = *window().findChild<QPushButton *>(QStringLiteral("startReplace"));
    click(replace, replace.rect());
    clickNotice(); // connect
    ASSERT_TRUE(bus().isOpen());
    exchange();
    clickDevice();
    clickNotice(); // replace it
    clickNext();   // the same make
    clickNext();   // the position before the swap
    clickNext();   // Write
    finish();
    EXPECT_EQ(clicks, 8);
}

INSTANTIATE_TEST_SUITE_P(Language, ReplacingByHand, testing::Values("en", "de"),
                         [](const auto &tested) { return std::string(tested.param); });

} // namespace
} // namespace codewheel
