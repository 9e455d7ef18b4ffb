// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/window/buses/plant.h"
#include "app/window/kinds/interbus/ring_at_work.h"
#include "tests/app/window_test.h"
#include "tests/support/register_bank.h"
#include "widgets/connect/connect_page.h"
#include "widgets/kinds/interbus/gateway/registers_page.h"
#include "widgets/kinds/interbus/training/training_panel.h"
#include "widgets/look/inline_message.h"
#include "widgets/structure/fault_banner.h"
#include "widgets/structure/structure_view.h"

#include <QAction>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QStackedWidget>
#include <QTest>
#include <QToolButton>
#include <QTreeView>

#include <algorithm>

namespace codewheel::test {

// The ring of the window is to be connected behind a gateway that is simulated by its registers.
class GatewayTest : public WindowTest
{
protected:
    GatewayTest()
    {
        ring().setPorts([this](const GatewaySettings &settings) {
            asked = settings;
            return std::make_unique<RegisterBankPort>(bank);
        });
        ringActions().disconnectBus->trigger();
        setIn(0, 1'234);
    }

    RingAtWork &ring() { return *shown->plant().first<RingAtWork>(); }
    ConnectPage &connection() { return *window().findChild<ConnectPage *>(QStringLiteral("ringConnection")); }
    RegistersPage &registers() { return *window().findChild<RegistersPage *>(); }
    static QPushButton &button(const QWidget &page, const QString &text)
    {
        for (auto *button : page.findChildren<QPushButton *>())
            if (button->text().remove(u'&') == text)
                return *button;
        ADD_FAILURE() << "no button " << text.toStdString();
        return *page.findChild<QPushButton *>();
    }
    static void click(QPushButton &button)
    {
        ASSERT_TRUE(button.isVisible() && button.isEnabled()) << button.text().toStdString();
        QTest::mouseClick(&button, Qt::LeftButton);
    }
    QString told(const QWidget &page)
    {
        for (const auto *message : page.findChildren<InlineMessage *>())
            if (message->isVisible())
                return message->sentence();
        return {};
    }
    void choose(const QString &host)
    {
        ringActions().connection->trigger();
        auto *link = connection().findChild<QComboBox *>(QStringLiteral("link"));
        link->setCurrentText(QStringLiteral("Modbus/TCP gateway"));
        auto *field = connection().findChild<QLineEdit *>(QStringLiteral("host"));
        field->setFocus();
        QTest::keyClicks(field, host);
    }
    // Of the form that is shown.
    template <typename Field>
    Field &setting(const char *name)
    {
        for (auto *field : connection().findChildren<Field *>(QLatin1String(name)))
            if (field->isVisibleTo(&connection()))
                return *field;
        ADD_FAILURE() << "no field " << name;
        return *connection().findChild<Field *>(QLatin1String(name));
    }
    void connectGateway()
    {
        choose(QStringLiteral("gateway.hall"));
        connectChosen();
    }
    void connectChosen()
    {
        click(button(connection(), QStringLiteral("Connect")));
        advance(20);
    }
    FaultBanner &banner() { return *window().findChild<FaultBanner *>(); }
    // What the tree shows, row by row.
    QString treeTexts(const QModelIndex &parent = {})
    {
        const QAbstractItemModel &rows =
            *window().findChild<StructureView *>()->findChild<QTreeView *>()->model();
        QString texts;
        for (int row = 0; row < rows.rowCount(parent); ++row) {
            for (int column = 0; column < rows.columnCount(parent); ++column)
                texts += rows.index(row, column, parent).data().toString() + u'|';
            texts += u'\n' + treeTexts(rows.index(row, 0, parent));
        }
        return texts;
    }
    void press(const char *button)
    {
        auto *its = banner().findChild<QToolButton *>(QLatin1String(button));
        ASSERT_TRUE(its->isVisible() && its->isEnabled()) << button;
        QTest::mouseClick(its, Qt::LeftButton);
    }
    bool isSaidToBeReal()
    {
        const auto *panel = window().findChild<TrainingPanel *>();
        const auto *shownHere = qobject_cast<QStackedWidget *>(panel->parentWidget())->currentWidget();
        return std::ranges::any_of(shownHere->findChildren<QLabel *>(), [](const QLabel *label) {
            return label->text() == QStringLiteral("Not a training bus");
        });
    }
    void setIn(int device, Word word) // of the first two, which have two registers each
    {
        bank->input[2 * device] = static_cast<Register>(word >> 16);
        bank->input[2 * device + 1] = static_cast<Register>(word);
    }
    Word outThere(int device)
    {
        return Word{bank->holding[2 * device]} << 16 | bank->holding[2 * device + 1];
    }

    std::shared_ptr<RegisterBank> bank = std::make_shared<RegisterBank>();
    std::optional<GatewaySettings> asked;
};

} // namespace codewheel::test
