// SPDX-License-Identifier: GPL-3.0-or-later
// The window and encoders that are given all their values at once and keep none.
#include "tests/kinds/plain/plain_in_window.h"
#include "vocabulary/state_text.h"
#include "widgets/job/known_text.h"
#include "widgets/parameters/wanted_values.h"
#include "widgets/transfer/transfer_lines.h"

#include <QAction>
#include <QCheckBox>
#include <QTableView>

#include <gmock/gmock.h>

namespace codewheel {
namespace {

using test::telegramWinch;
using testing::ElementsAre;

class TelegramInWindow : public test::PlainBusInWindow
{
protected:
    TelegramInWindow()
    {
        plainBus().setOperate(true);
        tree().choose(telegramWinch);
    }
    // The cells of the tables in sight, by rows.
    static std::string cells(const QWidget &view)
    {
        QStringList lines;
        for (const auto *table : view.findChildren<QTableView *>()) {
            const QAbstractItemModel &model = *table->model();
            for (int row = 0; table->isVisibleTo(&view) && row < model.rowCount(); ++row) {
                QStringList line;
                for (int column = 0; column < model.columnCount(); ++column)
                    line << model.index(row, column).data().toString();
                lines << line.join(u'|');
            }
        }
        return lines.join(u'\n').toStdString();
    }

    test::TelegramNode &node = plainBus().telegram(telegramWinch);
};

TEST_F(TelegramInWindow, ThePanelReviewsAllThatIsSent)
{
    EXPECT_EQ(cell(telegramWinch, StructureModel::positionColumn), "–");
    want(test::plainFilter(), QStringLiteral("-5"));
    review();
    EXPECT_THAT(cells(panel()), testing::HasSubstr("Steps|unknown|4096|all steps=4096"));
    EXPECT_TRUE(says(panel(), QStringLiteral("go along")));
    EXPECT_TRUE(says(panel(), QStringLiteral("at most 0")));
    EXPECT_EQ(panel().findChild<QPushButton *>(QStringLiteral("confirmWrite"))->toolTip(),
              QStringLiteral("Sends this; the encoder confirms it, and cannot be read"));
    const auto boxes = panel().findChildren<QCheckBox *>();
    EXPECT_TRUE(std::ranges::any_of(boxes, [](const QCheckBox *box) {
        return box->toolTip().contains(QStringLiteral("costs no EEPROM write"));
    }));
    confirm();
    EXPECT_THAT(node.heard(), ElementsAre("all steps=4096 direction=0 2000:1=-5 1008="));
    EXPECT_TRUE(says(panel(), QStringLiteral("EEPROM writes: 0")));
    EXPECT_FALSE(says(panel(), QStringLiteral("read back")));
    advance(100);
    EXPECT_EQ(cell(telegramWinch, StructureModel::positionColumn), std::to_string(node.position()));
}

TEST_F(TelegramInWindow, ItSaysThatItWaitsForItsValues)
{
    const auto tip = [this] {
        const auto &model = static_cast<const StructureModel &>(*tree().findChild<QTreeView *>()->model());
        return model.indexOf(telegramWinch)
            .siblingAtColumn(StructureModel::positionColumn)
            .data(Qt::ToolTipRole)
            .toString();
    };
    advance(100);
    EXPECT_TRUE(tip().contains(waitingText()));
    EXPECT_FALSE(leftInText(EncoderState::waiting).contains(QStringLiteral("run")));
    want(test::plainFilter(), QStringLiteral("-5"));
    review();
    confirm();
    EXPECT_FALSE(tip().contains(waitingText()));
    plainBus().switchOffAndOn(telegramWinch);
    advance(100);
    EXPECT_TRUE(tip().contains(waitingText()));
    review();
    EXPECT_THAT(cells(panel()), testing::HasSubstr("Filter|unknown|-5|all "));
}

TEST_F(TelegramInWindow, ATransferCountsNoWriteForAnyValue)
{
    Buses buses;
    buses.add(plainBus());
    const TransferPlan plan =
        planTransfer(buses, {{.place = telegramWinch, .values = {{test::plainFilter(), -5}}}});
    int along = 0;
    for (const ReviewRow &line : linesOf(buses, plan)) {
        EXPECT_NE(line.cells.value(5), QStringLiteral("1")) << line.cells.join(u'|').toStdString();
        along += line.tips.value(4).startsWith(QStringLiteral("Not wanted: it goes along"));
    }
    EXPECT_EQ(along, 3);
    buses.remove(&plainBus());
}

TEST_F(TelegramInWindow, TheWizardSendsAllInOneStep)
{
    window().findChild<WantedValues *>()->set(telegramWinch, test::plainFilter(), -5);
    actions().wizard->trigger();
    auto &wizard = *window().findChild<ParameterWizard *>();
    const auto *nextStep = window().findChild<QAbstractButton *>(QStringLiteral("nextStep"));
    std::string seen;
    bool note = false;
    for (int page = 0; page < 8 && !nextStep->isVisible(); ++page) {
        clickInWizard("wizardNext");
        seen += cells(wizard) + '\n';
        note = note || says(wizard, QStringLiteral("cannot be read: its confirmation is the evidence"));
        EXPECT_FALSE(says(wizard, QStringLiteral("after run")));
    }
    EXPECT_TRUE(note);
    EXPECT_THAT(seen, testing::HasSubstr("not wanted, goes along"));
    clickInWizard("nextStep");
    advance(200);
    EXPECT_FALSE(wizard.isBusy());
    EXPECT_THAT(node.heard(), ElementsAre("all steps=4096 direction=0 2000:1=-5 1008="));
    EXPECT_TRUE(says(wizard, QStringLiteral("Verified: confirmed by the encoder, which cannot be read.")));
}

} // namespace
} // namespace codewheel
