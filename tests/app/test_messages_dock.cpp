// SPDX-License-Identifier: GPL-3.0-or-later
// Messages, handshake trace and terminal in the window: the mark for new rows, and going from a row to its
// device.
#include "app/window/buses/plant.h"
#include "tests/app/window_test.h"
#include "widgets/look/inline_message.h"
#include "widgets/messages/message_model.h"
#include "widgets/messages/messages_view.h"
#include "widgets/structure/structure_view.h"
#include "widgets/trace/trace_view.h"

#include <QDockWidget>
#include <QTableView>

namespace codewheel {
namespace {

using test::baumer;
using test::fraba;

class MessagesDockTest : public test::WindowTest
{
protected:
    QDockWidget &dock(const char *name) { return *window().findChild<QDockWidget *>(QLatin1String(name)); }
    QTableView &table(const char *dockName)
    {
        auto &found = *dock(dockName).widget()->findChild<QTableView *>();
        dock(dockName).raise();
        advance(5);
        return found;
    }
    void tell(std::optional<Place> place, Severity severity)
    {
        shown->messages().addNow({.place = place,
                                  .severity = severity,
                                  .id = MessageId::training,
                                  .arguments = {QStringLiteral("something")}});
        shown->messages().catchUp();
    }
    void goFromNewestMessage()
    {
        QTableView &messages = table("messagesDock");
        const QModelIndex newest = messages.model()->index(messages.model()->rowCount() - 1, 0);
        QTest::mouseClick(messages.viewport(), Qt::LeftButton, {}, messages.visualRect(newest).center());
        QTest::keyClick(&messages, Qt::Key_G, Qt::ControlModifier);
        advance(5);
    }
    std::optional<Place> row() { return window().findChild<StructureView *>()->row(); }
};

TEST_F(MessagesDockTest, TheTabSaysHowMuchWasNotSeenYet)
{
    table("messagesDock");
    EXPECT_EQ(dock("messagesDock").windowTitle(), QStringLiteral("Messages"));
    table("traceDock");
    tell(fraba, Severity::information);
    EXPECT_EQ(dock("messagesDock").windowTitle(), QStringLiteral("Messages"));
    tell(fraba, Severity::fault);
    tell(fraba, Severity::attention);
    EXPECT_EQ(dock("messagesDock").windowTitle(), QStringLiteral("Messages (2)"));
    table("messagesDock");
    EXPECT_TRUE(
        QTest::qWaitFor([this] { return dock("messagesDock").windowTitle() == QStringLiteral("Messages"); }));
}

TEST_F(MessagesDockTest, AMessageLeadsToItsDeviceOrBus)
{
    tell(baumer, Severity::fault);
    goFromNewestMessage();
    EXPECT_EQ(row(), baumer);
    tell(Place{baumer.bus, {}}, Severity::fault);
    goFromNewestMessage();
    EXPECT_EQ(row(), (Place{baumer.bus, {}}));
}

TEST_F(MessagesDockTest, ADeviceThatIsNotThereIsSaidToBe)
{
    tell("9.0"_ring, Severity::fault);
    goFromNewestMessage();
    bool isSaid = false;
    for (const auto *message : window().findChildren<InlineMessage *>())
        isSaid =
            isSaid || (message->isVisible() && message->sentence().startsWith(QStringLiteral("9.0 is not")));
    EXPECT_TRUE(isSaid);
}

TEST_F(MessagesDockTest, TheTraceLeadsToItsEncoderFromTheRowOfTheBus)
{
    auto &tree = *window().findChild<StructureView *>();
    tree.choose(fraba);
    tree.choose(fraba.bus);
    ASSERT_EQ(row(), (Place{fraba.bus, {}}));
    QTableView &trace = table("traceDock");
    trace.setFocus();
    QTest::keyClick(&trace, Qt::Key_G, Qt::ControlModifier);
    EXPECT_EQ(row(), fraba);
}

} // namespace
} // namespace codewheel
