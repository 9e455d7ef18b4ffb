// SPDX-License-Identifier: GPL-3.0-or-later
// The tool bar: the pages, and Watch | Operate beside ALARM STOP, with mouse, keys and a screen reader.
#include "language.h"
#include "tests/app/window_test.h"
#include "widgets/look/appearance.h"
#include "widgets/structure/structure_view.h"

#include <QAccessible>
#include <QAction>
#include <QLocale>
#include <QRadioButton>
#include <QSet>
#include <QToolBar>
#include <QToolButton>

namespace codewheel {
namespace {

class ToolBarTest : public test::WindowTest
{
protected:
    QToolBar &bar() { return *window().findChild<QToolBar *>(QStringLiteral("busToolBar")); }
    QRadioButton &part(const char *name) { return *bar().findChild<QRadioButton *>(QLatin1String(name)); }
    QToolButton &button(QAction *action)
    {
        return *qobject_cast<QToolButton *>(bar().widgetForAction(action));
    }
    QToolButton &alarmStop() { return *bar().findChild<QToolButton *>(QStringLiteral("alarmStop")); }
    void expectAllSeen(const std::string &what)
    {
        advance(50);
        const QList<QWidget *> all{&part("watch"), &part("operate"), &alarmStop()};
        for (const QWidget *each : all) {
            const QRect place(each->mapTo(&bar(), QPoint()), each->size());
            EXPECT_TRUE(each->isVisible()) << what;
            EXPECT_TRUE(bar().rect().contains(place)) << what;
            EXPECT_GE(each->width(), each->sizeHint().width()) << what;
        }
        for (QAction *action : bar().actions())
            if (auto *each = qobject_cast<QToolButton *>(bar().widgetForAction(action))) {
                EXPECT_TRUE(each->isVisible()) << what << action->text().toStdString();
                EXPECT_GE(each->width(), each->sizeHint().width()) << what << action->text().toStdString();
            }
    }
};

TEST_F(ToolBarTest, BeginsWithTheMonitorsAndThePages)
{
    const WindowActions &its = actions();
    const QList<QAction *> pages{its.monitors,        its.trend,   its.wizard,   its.cams,
                                 its.structureEditor, its.compare, its.transfer, its.replaceEncoder};
    EXPECT_EQ(bar().actions().mid(0, pages.size()), pages);
    window().findChild<StructureView *>()->choose(test::fraba);
    QSet<const QWidget *> opened;
    for (QAction *open : pages) {
        QTest::mouseClick(&button(open), Qt::LeftButton);
        opened << page();
    }
    EXPECT_EQ(opened.size(), pages.size());
}

TEST_F(ToolBarTest, TheSwitchIsOneOfTwo)
{
    EXPECT_TRUE(part("operate").isChecked());
    QTest::mouseClick(&part("watch"), Qt::LeftButton);
    advance(50);
    EXPECT_FALSE(bus().isOperating());
    EXPECT_TRUE(part("watch").isChecked());
    EXPECT_FALSE(part("operate").isChecked());
    QTest::mouseClick(&part("watch"), Qt::LeftButton);
    EXPECT_TRUE(part("watch").isChecked()) << "a second click changes nothing";
    part("watch").setFocus();
    QTest::keyClick(&part("watch"), Qt::Key_Right);
    advance(50);
    EXPECT_TRUE(bus().isOperating());
    QTest::keyClick(&window(), Qt::Key_F11, Qt::ControlModifier);
    advance(50);
    EXPECT_TRUE(part("watch").isChecked());
    QTest::keyClick(&window(), Qt::Key_F11, Qt::ControlModifier | Qt::ShiftModifier);
    advance(50);
    EXPECT_TRUE(part("operate").isChecked());
    const auto *heard = QAccessible::queryAccessibleInterface(&part("operate"));
    EXPECT_EQ(heard->role(), QAccessible::RadioButton);
    EXPECT_TRUE(heard->state().checked);
}

TEST_F(ToolBarTest, TheSwitchTellsTheBusItMeans)
{
    EXPECT_EQ(part("watch").accessibleName(), QStringLiteral("Ring: Watch"));
    EXPECT_EQ(actions().watch->text(), QStringLiteral("&Watch (Ring)"));
    window().findChild<StructureView *>()->choose(placeOnLine({0x05}));
    EXPECT_EQ(part("watch").accessibleName(), QStringLiteral("Line: Watch"));
    lineActions().disconnectBus->trigger();
    window().findChild<StructureView *>()->choose(test::fraba);
    EXPECT_EQ(part("watch").accessibleName(), QStringLiteral("Watch")) << "there is one bus";
}

struct Narrow
{
    const char *name;
    const char *language;
    bool largeControls;
};

void PrintTo(const Narrow &tested, std::ostream *out)
{
    *out << tested.name;
}

class NarrowToolBar : public ToolBarTest, public testing::WithParamInterface<Narrow>
{
protected:
    NarrowToolBar()
    {
        applyAppearance(*qApp, {.scheme = Scheme::light, .largeControls = GetParam().largeControls});
        language.use(QString::fromLatin1(GetParam().language));
        open(); // in this language
    }
    ~NarrowToolBar() override
    {
        applyAppearance(*qApp, {.scheme = Scheme::light});
        QLocale::setDefault(QLocale::c());
    }

private:
    Language language;
};

TEST_P(NarrowToolBar, LosesWordsAndNoButton)
{
    window().resize(1024, 640);
    expectAllSeen("1024 ");
    EXPECT_EQ(window().width(), 1024);
    Project project = shown->project().project();
    for (PlannedBus &each : project.buses)
        each.name = QStringLiteral("The ring of the second crane on the quay in the east");
    shown->project().edit(project, QStringLiteral("long names"));
    expectAllSeen("long names ");
    window().resize(1920, 800);
    expectAllSeen("1920 ");
    EXPECT_EQ(button(actions().replaceEncoder).toolButtonStyle(), Qt::ToolButtonTextBesideIcon);
    window().resize(400, 640);
    expectAllSeen("as narrow as it can be ");
}

INSTANTIATE_TEST_SUITE_P(Controls, NarrowToolBar,
                         testing::Values(Narrow{"Usual", "en", false}, Narrow{"Large", "en", true},
                                         Narrow{"UsualGerman", "de", false},
                                         Narrow{"LargeGerman", "de", true}),
                         [](const auto &tested) { return tested.param.name; });

} // namespace
} // namespace codewheel
