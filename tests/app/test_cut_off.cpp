// SPDX-License-Identifier: GPL-3.0-or-later
// Nothing is cut off, in any language, any size of the window, with normal or large controls.
#include "app/screenshots/kinds/manual_pictures.h"
#include "language.h"
#include "tests/app/window_test.h"
#include "tests/replay/replay_recording.h"
#include "tests/support/cut_off.h"
#include "widgets/look/appearance.h"
#include "widgets/look/inline_message.h"
#include "widgets/structure/structure_view.h"
#include "widgets/trend/trend_page.h"

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QLocale>
#include <QPushButton>
#include <QSpinBox>

#include <gtest/gtest.h>

namespace codewheel {

inline void PrintTo(const Picture &picture, std::ostream *out)
{
    *out << picture.name.toStdString();
}

namespace {

struct Shown
{
    const char *name;
    const char *language;
    QSize size;
    bool largeControls;
};

void PrintTo(const Shown &shown, std::ostream *out)
{
    *out << shown.name;
}

// Of a bus that only tests have; it has a tab beside those of the program.
void takeOffPlainPanel(MainWindow &window)
{
    if (auto *panel = window.findChild<QDockWidget *>(QStringLiteral("plainDock")))
        window.removeDockWidget(panel);
}

class NothingIsCutOff : public test::WindowTest, public testing::WithParamInterface<Shown>
{
protected:
    NothingIsCutOff()
    {
        applyAppearance(*qApp, {.scheme = Scheme::light, .largeControls = GetParam().largeControls});
        language.use(QString::fromLatin1(GetParam().language));
        open(); // in this language
        window().resize(GetParam().size);
        actions().defaultLayout->trigger();
        resizeTo(GetParam().size);
        advance(99);
    }
    ~NothingIsCutOff() override
    {
        applyAppearance(*qApp, {.scheme = Scheme::light});
        QLocale::setDefault(QLocale::c());
    }

    void look(QWidget &part, const QString &where)
    {
        advance(50);
        for (const QString &cut : test::cutOff(part))
            ADD_FAILURE() << where.toStdString() << ": " << cut.toStdString();
    }

private:
    Language language;
};

TEST_P(NothingIsCutOff, OnAnyPage)
{
    for (QAction *action :
         {actions().monitors, actions().showInTrend, actions().wizard, actions().cams,
          actions().structureEditor, actions().compare, actions().transfer, actions().replaceEncoder,
          lineActions().settings, lineActions().search, canActions().settings, canActions().search,
          canActions().unnumbered, actions().projectPage}) {
        action->trigger();
        look(*window().centralWidget(), action->text());
    }
}

TEST_P(NothingIsCutOff, WhereANodeGetsItsNumber)
{
    canActions().training->trigger();
    advance(500);
    window().findChild<StructureView *>()->choose(Place{BusId{3}, NodeId("can:6")});
    advance(50);
    canActions().setup->trigger();
    const auto press = [this](const char *name, int milliseconds) {
        window().findChild<QPushButton *>(QLatin1String(name))->click();
        advance(milliseconds);
    };
    press("nodeSetupRead", 300);
    window().findChild<QSpinBox *>(QStringLiteral("nodeSetupNumber"))->setValue(9);
    look(*window().centralWidget(), QStringLiteral("A number that was chosen"));
    press("nodeSetupWrite", 50);
    look(*window().centralWidget(), QStringLiteral("The question about a number"));
    auto *question = window().findChild<InlineMessage *>(QStringLiteral("nodeSetupMessage"));
    question->findChild<QPushButton *>()->click();
    advance(100);
    look(*window().centralWidget(), QStringLiteral("The steps of a number"));
}

TEST_P(NothingIsCutOff, WithARecording)
{
    const test::ReplayRecording recording;
    ASSERT_TRUE(window().openRecording(recording.path));
    advance(99);
    look(*window().centralWidget(), QStringLiteral("Recording"));
    actions().trend->trigger();
    window().findChild<TrendPage *>()->showTrack(
        {shown->plant().histories().archives().front()->places().front(), Channel::position, {}});
    look(*window().centralWidget(), QStringLiteral("Trend of a recording"));
    EXPECT_EQ(window().width(), GetParam().size.width());
    actions().monitors->trigger(); // the panels at the bottom come back
    advance(50);
    for (auto *panel : window().findChildren<QDockWidget *>()) {
        if (panel->isHidden())
            continue;
        panel->raise();
        look(*panel, panel->windowTitle());
    }
}

TEST_P(NothingIsCutOff, InAnyPanel)
{
    for (auto *panel : window().findChildren<QDockWidget *>()) {
        panel->show();
        panel->raise();
        look(*panel, panel->windowTitle());
    }
}

TEST_P(NothingIsCutOff, AroundThem)
{
    takeOffPlainPanel(window());
    for (QObject *child : window().children())
        if (auto *part = qobject_cast<QWidget *>(child);
            part != nullptr && part != window().centralWidget() &&
            qobject_cast<QDockWidget *>(part) == nullptr && part->isVisible() && !part->isWindow())
            look(*part, QStringLiteral("Around"));
}

INSTANTIATE_TEST_SUITE_P(
    Shown, NothingIsCutOff,
    testing::Values(Shown{"Small", "en", {960, 600}, false}, Shown{"SmallGerman", "de", {960, 600}, false},
                    Shown{"SmallLargeGerman", "de", {1024, 640}, true},
                    Shown{"Usual", "en", {1280, 800}, false}, Shown{"UsualGerman", "de", {1280, 800}, false},
                    Shown{"UsualLargeGerman", "de", {1280, 800}, true},
                    Shown{"Wide", "en", {1920, 1080}, false}, Shown{"WideGerman", "de", {1920, 1080}, false},
                    Shown{"WideLargeGerman", "de", {1920, 1080}, true}),
    [](const auto &tested) { return tested.param.name; });

// German has the longer words; modal windows are checked as they appear.
class NothingOfTheManualIsCutOff : public testing::TestWithParam<Picture>
{
protected:
    NothingOfTheManualIsCutOff() { language.use(QStringLiteral("de")); }
    ~NothingOfTheManualIsCutOff() override
    {
        applyAppearance(*qApp, {.scheme = Scheme::light});
        QLocale::setDefault(QLocale::c());
    }

    void look(TrainingWindow &shown, QWidget &seen, QSize size, bool largeControls)
    {
        applyAppearance(*qApp, {.scheme = Scheme::light, .largeControls = largeControls});
        shown.window().resize(size);
        shown.window().actions().defaultLayout->trigger();
        shown.window().resize(size);
        test::waitUntilSettled(shown.window());
        takeOffPlainPanel(shown.window());
        shown.advance(33); // the first panels come to the front
        if (auto *dock = qobject_cast<QDockWidget *>(&seen)) {
            dock->show(); // some are not at first
            dock->raise();
        }
        shown.advance(99); // each row of a layout tells the one around it
        for (const QString &cut : test::cutOff(seen))
            ADD_FAILURE() << size.width() << (largeControls ? ", large: " : ": ") << cut.toStdString();
    }

private:
    Language language;
};

TEST_P(NothingOfTheManualIsCutOff, InAnySize)
{
    const QTemporaryDir settings;
    TrainingWindow shown(settings.filePath(QStringLiteral("window.ini")), GetParam().window);
    shown.window().show();
    shown.advance(beforePicture);
    GetParam().show(shown, [&](QWidget &seen) {
        for (const bool largeControls : {false, true})
            for (const QSize size : {QSize(1024, 640), QSize(1280, 800), QSize(1920, 1080)})
                look(shown, seen, size, largeControls);
    });
}

INSTANTIATE_TEST_SUITE_P(
    Pictures, NothingOfTheManualIsCutOff, testing::ValuesIn(manualPictures()), [](const auto &tested) {
        return QString(tested.param.name).replace(QLatin1Char('-'), QLatin1Char('_')).toStdString();
    });

} // namespace
} // namespace codewheel
