// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/typed_text.h"
#include "widgets/palette/command_palette.h"
#include "widgets/palette/palette_model.h"

#include <QAccessible>
#include <QApplication>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QPushButton>
#include <QTest>
#include <QVBoxLayout>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

class GivenParts : public PaletteSource
{
public:
    explicit GivenParts(std::vector<std::vector<PaletteEntry>> parts)
        : m_parts(std::move(parts))
    {}
    void begin() override { m_next = 0; }
    std::vector<PaletteEntry> next() override
    {
        return m_next < m_parts.size() ? m_parts[m_next++] : std::vector<PaletteEntry>();
    }

private:
    const std::vector<std::vector<PaletteEntry>> m_parts;
    std::size_t m_next = 0;
};

class CommandPaletteTest : public testing::Test
{
protected:
    CommandPaletteTest()
    {
        before = new QLineEdit(&window);
        outside = new QPushButton(QStringLiteral("outside"), &window);
        auto *rows = new QVBoxLayout(&window);
        rows->addWidget(before);
        rows->addStretch();
        rows->addWidget(outside);
        palette = new CommandPalette(window);
        palette->addSource(std::make_unique<GivenParts>(std::vector{entries(), laterEntries()}));
        QObject::connect(palette, &CommandPalette::used, palette, [this](const QString &id) { used << id; });
        window.resize(900, 600);
        window.show();
        window.activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&window));
        before->setFocus();
        palette->open();
        EXPECT_TRUE(QTest::qWaitFor([this] { return palette->isComplete(); }));
    }

    PaletteEntry entry(const QString &title, const QString &context = {}, const QString &words = {})
    {
        return {.id = title, .title = title, .context = context, .words = words, .run = [this, title] {
                    focusAtRun = QApplication::focusWidget();
                    ran << title;
                }};
    }
    std::vector<PaletteEntry> entries()
    {
        PaletteEntry save = entry(QStringLiteral("Save"), QStringLiteral("File"));
        save.key = QStringLiteral("Ctrl+S");
        save.isUsual = true;
        PaletteEntry stop = entry(QStringLiteral("Stop"), QStringLiteral("Bus"));
        stop.state = [] { return PaletteState{false, QStringLiteral("No bus is open.")}; };
        return {entry(QStringLiteral("Unsaved changes")),
                entry(QStringLiteral("Save as"), QStringLiteral("File")),
                save,
                stop,
                entry(QStringLiteral("Leitung prüfen"), QStringLiteral("Bus")),
                entry(QStringLiteral("Größe"), {}, QStringLiteral("Übermaß")),
                entry(QStringLiteral("Trend"), QStringLiteral("View"), QStringLiteral("curves to save"))};
    }
    std::vector<PaletteEntry> laterEntries()
    {
        std::vector<PaletteEntry> messages;
        for (int i = 0; i < 40; ++i) {
            messages.push_back(entry(QStringLiteral("Message %1 that is rather long").arg(40 - i)));
            messages.back().kind = PaletteEntry::Kind::message;
            messages.back().id.clear();
        }
        return messages;
    }

    void press(Qt::Key key) { QTest::keyClick(QApplication::focusWidget(), key); }
    void type(const QString &text)
    {
        field().clear();
        test::typeText(text);
    }
    QLineEdit &field() { return *palette->findChild<QLineEdit *>(); }
    QListView &list() { return *palette->findChild<QListView *>(); }
    QStringList titles()
    {
        QStringList titles;
        for (int row = 0; row < list().model()->rowCount(); ++row)
            titles << list().model()->index(row, 0).data().toString();
        return titles;
    }
    QString chosen() { return list().currentIndex().data().toString(); }
    QStringList found(const QString &text)
    {
        type(text);
        return titles();
    }

    QWidget window;
    QLineEdit *before = nullptr;
    QPushButton *outside = nullptr;
    CommandPalette *palette = nullptr;
    QStringList ran;
    QStringList used;
    const QWidget *focusAtRun = nullptr;
};

TEST_F(CommandPaletteTest, BeginningsComeBeforeMiddlesAndShortTitlesBeforeLong)
{
    EXPECT_EQ(found(QStringLiteral("save")),
              (QStringList{QStringLiteral("Save"), QStringLiteral("Save as"), QStringLiteral("Trend"),
                           QStringLiteral("Unsaved changes")}));
}

TEST_F(CommandPaletteTest, AKeyComesBeforeWhatOnlyContainsIt)
{
    PaletteEntry alarm = entry(QStringLiteral("Alarm"));
    alarm.key = QStringLiteral("Ctrl+F12");
    PaletteEntry why = entry(QStringLiteral("Why is there no data?"));
    why.key = QStringLiteral("F12");
    palette->addSource(std::make_unique<GivenParts>(std::vector<std::vector<PaletteEntry>>{{alarm, why}}));
    palette->hide();
    palette->open();
    EXPECT_TRUE(QTest::qWaitFor([this] { return palette->isComplete(); }));
    EXPECT_EQ(found(QStringLiteral("f12")), (QStringList{why.title, alarm.title}));
    EXPECT_EQ(chosen(), why.title);
}

TEST_F(CommandPaletteTest, WhatIsNotAvailableComesAfterWhatFitsAlmostAsWell)
{
    PaletteEntry stops = entry(QStringLiteral("Ring"), {}, QStringLiteral("stop it"));
    PaletteEntry nonstop = entry(QStringLiteral("Nonstop"));
    palette->addSource(
        std::make_unique<GivenParts>(std::vector<std::vector<PaletteEntry>>{{stops, nonstop}}));
    palette->hide();
    palette->open();
    EXPECT_TRUE(QTest::qWaitFor([this] { return palette->isComplete(); }));
    EXPECT_EQ(found(QStringLiteral("stop")),
              (QStringList{stops.title, QStringLiteral("Stop"), nonstop.title}));
}

TEST_F(CommandPaletteTest, AllWordsMatchInAnyOrderAndAnywhere)
{
    EXPECT_EQ(found(QStringLiteral("file as")), QStringList{QStringLiteral("Save as")});
    EXPECT_EQ(found(QStringLiteral("VIEW curv")), QStringList{QStringLiteral("Trend")});
    EXPECT_EQ(found(QStringLiteral("ctrl+s")), QStringList{QStringLiteral("Save")});
    EXPECT_EQ(found(QStringLiteral("view save file")), QStringList());
}

TEST_F(CommandPaletteTest, AnUmlautIsFoundHoweverItIsTyped)
{
    for (const QString &typed :
         {QStringLiteral("prüfen"), QStringLiteral("pruefen"), QStringLiteral("PRUFEN"),
          QStringLiteral("prue"), QStringLiteral("leitung pruef")})
        EXPECT_EQ(found(typed), QStringList{QStringLiteral("Leitung prüfen")}) << typed.toStdString();
    for (const QString &typed :
         {QStringLiteral("groesse"), QStringLiteral("größe"), QStringLiteral("uebermass")})
        EXPECT_EQ(found(typed), QStringList{QStringLiteral("Größe")}) << typed.toStdString();
}

TEST_F(CommandPaletteTest, EachLetterTypedOnNarrowsWhatWasFoundAndDeletingWidensIt)
{
    const QString text = QStringLiteral("message 12");
    field().clear();
    for (const QChar letter : text)
        QTest::keyClicks(QApplication::focusWidget(), letter);
    EXPECT_EQ(titles(), QStringList{QStringLiteral("Message 12 that is rather long")});
    press(Qt::Key_Backspace);
    EXPECT_EQ(titles().size(), 13) << "1, 10 to 19, 21, 31";
}

TEST_F(CommandPaletteTest, WhatIsFoundByWordsThatAreNotShownShowsThem)
{
    type(QStringLiteral("curves"));
    EXPECT_EQ(list().currentIndex().data(PaletteModel::contextRole).toString(),
              QStringLiteral("Action · View · curves to save"));
    type(QStringLiteral("view"));
    EXPECT_EQ(list().currentIndex().data(PaletteModel::contextRole).toString(),
              QStringLiteral("Action · View"));
}

TEST_F(CommandPaletteTest, AKindIsFoundByItsWordAndMessagesComeLast)
{
    EXPECT_EQ(found(QStringLiteral("action")).size(), 7);
    const QStringList both = found(QStringLiteral("a"));
    EXPECT_FALSE(both.first(7).contains(QStringLiteral("Message 40 that is rather long")));
    EXPECT_EQ(both.size(), 47);
}

TEST_F(CommandPaletteTest, TheNewestMessagesComeFirst)
{
    EXPECT_EQ(found(QStringLiteral("message")).first(2),
              (QStringList{QStringLiteral("Message 40 that is rather long"),
                           QStringLiteral("Message 39 that is rather long")}));
}

TEST_F(CommandPaletteTest, TheKeysMoveAndReturnRunsWithTheFocusWhereItWas)
{
    type(QStringLiteral("save"));
    EXPECT_EQ(chosen(), QStringLiteral("Save"));
    press(Qt::Key_Down);
    EXPECT_EQ(chosen(), QStringLiteral("Save as"));
    press(Qt::Key_Up);
    press(Qt::Key_Up);
    EXPECT_EQ(chosen(), QStringLiteral("Unsaved changes")) << "around";
    press(Qt::Key_Down);
    press(Qt::Key_Return);
    EXPECT_EQ(ran, QStringList{QStringLiteral("Save")});
    EXPECT_EQ(used, ran);
    EXPECT_EQ(focusAtRun, before);
    EXPECT_FALSE(palette->isVisible());
}

TEST_F(CommandPaletteTest, APageIsTheRowsInSight)
{
    type(QStringLiteral("message"));
    press(Qt::Key_PageDown);
    const int page = list().currentIndex().row();
    EXPECT_GE(page, 5);
    press(Qt::Key_PageDown);
    EXPECT_EQ(list().currentIndex().row(), 2 * page);
    for (int i = 0; i < 9; ++i)
        press(Qt::Key_PageDown);
    EXPECT_EQ(list().currentIndex().row(), 39) << "it stays at the end";
    press(Qt::Key_PageUp);
    EXPECT_EQ(list().currentIndex().row(), 39 - page);
}

TEST_F(CommandPaletteTest, EscClosesItAndGivesTheFocusBack)
{
    EXPECT_EQ(QApplication::focusWidget(), &field());
    press(Qt::Key_Escape);
    EXPECT_FALSE(palette->isVisible());
    EXPECT_EQ(QApplication::focusWidget(), before);
    EXPECT_EQ(ran, QStringList());
}

TEST_F(CommandPaletteTest, AClickRunsAndOneBesideItCloses)
{
    type(QStringLiteral("trend"));
    QTest::mouseClick(list().viewport(), Qt::LeftButton, {},
                      list().visualRect(list().currentIndex()).center());
    EXPECT_EQ(ran, QStringList{QStringLiteral("Trend")});
    palette->open();
    QTest::mouseClick(outside, Qt::LeftButton);
    EXPECT_FALSE(palette->isVisible());
}

TEST_F(CommandPaletteTest, WhatIsNotAvailableSaysWhyAndDoesNotRun)
{
    type(QStringLiteral("stop"));
    EXPECT_TRUE(list()
                    .currentIndex()
                    .data(PaletteModel::contextRole)
                    .toString()
                    .endsWith(QStringLiteral("No bus is open.")));
    press(Qt::Key_Return);
    EXPECT_EQ(ran, QStringList());
    EXPECT_TRUE(palette->isVisible());
}

TEST_F(CommandPaletteTest, ThatNothingIsFoundIsASentence)
{
    type(QStringLiteral("xyzzy"));
    const auto *sentence = palette->findChild<QLabel *>(QStringLiteral("paletteNothing"));
    EXPECT_TRUE(sentence->isVisible());
    EXPECT_TRUE(sentence->text().contains(QStringLiteral("xyzzy")));
    EXPECT_FALSE(list().isVisible());
    press(Qt::Key_Down);
    press(Qt::Key_Return);
    EXPECT_EQ(ran, QStringList());
}

TEST_F(CommandPaletteTest, AnEmptyFieldOffersWhatWasUsedLastThenTheUsual)
{
    EXPECT_EQ(titles(), QStringList{QStringLiteral("Save")});
    press(Qt::Key_Escape);
    palette->setUsed({QStringLiteral("Trend"), QStringLiteral("gone since"), QStringLiteral("Größe")});
    palette->open();
    EXPECT_TRUE(QTest::qWaitFor([this] { return palette->isComplete(); }));
    EXPECT_EQ(titles(),
              (QStringList{QStringLiteral("Trend"), QStringLiteral("Größe"), QStringLiteral("Save")}));
}

TEST_F(CommandPaletteTest, AScreenReaderReadsTheRowThatIsChosen)
{
    type(QStringLiteral("save"));
    press(Qt::Key_Down);
    auto *interface = QAccessible::queryAccessibleInterface(&list());
    EXPECT_EQ(interface->child(1)->text(QAccessible::Name), QStringLiteral("Save as, Action · File"));
    EXPECT_EQ(field().accessibleDescription(), QStringLiteral("Save as, Action · File"));
}

TEST_F(CommandPaletteTest, ItStaysWithinItsWindow)
{
    for (const QSize size : {QSize(1600, 1000), QSize(500, 320)}) {
        window.resize(size);
        type(QStringLiteral("message"));
        EXPECT_TRUE(window.rect().contains(palette->geometry())) << size.width();
        EXPECT_TRUE(list().viewport()->rect().contains(list().visualRect(list().currentIndex())));
    }
}

} // namespace
} // namespace codewheel
