// SPDX-License-Identifier: GPL-3.0-or-later
// Alt and a letter does one thing: no two visible widgets of a page or panel, and no two menus, share a
// mnemonic.
#include "language.h"
#include "tests/app/window_test.h"

#include <QAbstractButton>
#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QKeySequence>
#include <QLabel>
#include <QLocale>
#include <QMenuBar>
#include <QWidget>

#include <gtest/gtest.h>
#include <map>
#include <set>

namespace codewheel {
namespace {

class Mnemonics : public test::WindowTest, public testing::WithParamInterface<const char *>
{
protected:
    using Owners = std::map<QKeySequence, QString>; // the text that has the key

    Mnemonics()
    {
        language.use(QString::fromLatin1(GetParam()));
        open(); // in this language
        for (const QAction *menu : window().menuBar()->actions())
            take(m_menus, menu->text(), QStringLiteral("menu bar"));
        EXPECT_EQ(m_menus.size(), static_cast<std::size_t>(window().menuBar()->actions().size()));
    }
    ~Mnemonics() override { QLocale::setDefault(QLocale::c()); }

    // The number of keys the part adds to those of the menu bar.
    std::size_t check(const QWidget &part, const QString &name)
    {
        advance(50);
        EXPECT_TRUE(part.isVisible()) << name.toStdString();
        Owners owners = m_menus;
        for (const auto *button : part.findChildren<QAbstractButton *>())
            if (button->isVisible())
                take(owners, button->text(), name);
        for (const auto *label : part.findChildren<QLabel *>())
            if (label->isVisible() && label->buddy() != nullptr)
                take(owners, label->text(), name);
        return owners.size() - m_menus.size();
    }

private:
    void take(Owners &owners, const QString &text, const QString &where)
    {
        const QKeySequence key = QKeySequence::mnemonic(text);
        if (key.isEmpty())
            return;
        const auto [owner, isFirst] = owners.emplace(key, text);
        EXPECT_TRUE(isFirst) << where.toStdString() << ": " << key.toString().toStdString() << " for "
                             << text.toStdString() << " and " << owner->second.toStdString();
    }

    Language language;
    Owners m_menus;
};

TEST_P(Mnemonics, AreUniqueOnEveryPage)
{
    std::set<const QWidget *> seen;
    for (QAction *action :
         {actions().monitors, actions().showInTrend, actions().wizard, actions().cams,
          actions().structureEditor, actions().compare, actions().transfer, actions().replaceEncoder,
          lineActions().settings, lineActions().search, canActions().settings, canActions().search,
          canActions().unnumbered, actions().projectPage, ringActions().offer}) {
        action->trigger();
        EXPECT_TRUE(seen.insert(page()).second) << action->text().toStdString() << " opens its page";
        // There may be many monitors; each uses its own keys only while it has the focus.
        const std::size_t fewest = action == actions().monitors ? 0 : 1;
        EXPECT_GE(check(*window().centralWidget(), action->text()), fewest) << action->text().toStdString();
    }
}

TEST_P(Mnemonics, AreUniqueWithEachKindOfLink)
{
    for (QAction *action : {ringActions().connection, lineActions().settings, canActions().settings}) {
        action->trigger();
        auto *link = page()->findChild<QComboBox *>(QStringLiteral("link"));
        for (int i = 0; i < link->count(); ++i) {
            link->setCurrentIndex(i);
            EXPECT_GE(check(*window().centralWidget(), link->itemText(i)), 2U)
                << link->itemText(i).toStdString();
        }
    }
}

TEST_P(Mnemonics, AreUniqueInEveryPanel)
{
    std::size_t keys = 0;
    for (auto *panel : window().findChildren<QDockWidget *>()) {
        panel->show();
        panel->raise();
        keys += check(*panel, panel->windowTitle());
    }
    EXPECT_GE(keys, 5U);
}

INSTANTIATE_TEST_SUITE_P(Language, Mnemonics, testing::Values("en", "de"),
                         [](const auto &tested) { return tested.param; });

} // namespace
} // namespace codewheel
