// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/paper/printed_table.h"
#include "app/window/paper/printing.h"
#include "tests/app/question.h"
#include "tests/app/window_test.h"
#include "widgets/cams/cam_table.h"
#include "widgets/dial/dial_panel.h"
#include "widgets/dial/rod_view.h"
#include "widgets/look/label_text.h"
#include "widgets/messages/messages_view.h"
#include "widgets/structure/structure_view.h"

#include <QAction>
#include <QApplication>
#include <QContextMenuEvent>
#include <QFile>
#include <QMenu>
#include <QPrinter>
#include <QPrintPreviewDialog>
#include <QTableView>
#include <QTableWidget>
#include <QTest>
#include <QTextDocument>
#include <QTimer>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::HasSubstr;

class PrintingTest : public test::WindowTest
{
protected:
    PrintingTest() { shown->messages().catchUp(); }

    // The preview, and what it would print, as a PDF.
    QByteArray printed(QString &name)
    {
        QByteArray pdf;
        const test::Question question([&](QWidget &dialog) {
            auto &preview = dynamic_cast<QPrintPreviewDialog &>(dialog);
            name = preview.printer()->docName();
            QPrinter printer;
            printer.setOutputFormat(QPrinter::PdfFormat);
            printer.setOutputFileName(folder.filePath(QStringLiteral("printed.pdf")));
            window().findChild<Printing *>()->print(printer);
            preview.close();
        });
        actions().print->trigger();
        EXPECT_TRUE(question.wasAsked());
        QFile file(folder.filePath(QStringLiteral("printed.pdf")));
        EXPECT_TRUE(file.open(QIODevice::ReadOnly));
        return file.readAll();
    }
};

TEST_F(PrintingTest, PrintsTheTableThatHasTheFocus)
{
    window().findChild<MessagesView *>()->findChild<QTableView *>()->setFocus();
    QString name;
    EXPECT_TRUE(printed(name).startsWith("%PDF-"));
    EXPECT_EQ(name, QStringLiteral("Messages"));
}

TEST_F(PrintingTest, PrintsTheReportWhereThereIsNoTable)
{
    actions().openMonitor->trigger();
    monitors().findChild<WordCard *>()->setFocus();
    QString name;
    const auto sheets = printed(name).count("/Type /Page\n");
    EXPECT_EQ(name, QStringLiteral("Commissioning report"));
    EXPECT_GT(sheets, 1);
}

// What stands under a name among the values of the picture that has the focus.
std::string printedValue(const QString &name)
{
    const auto view = viewToPrint(QApplication::focusWidget());
    for (const auto &[key, value] : view ? view->values : PrintedView().values)
        if (key == name)
            return value.toStdString();
    return "none";
}

TEST_F(PrintingTest, PrintsTheDialAsAPictureWithLinesOnOneSheet)
{
    window().findChild<StructureView *>()->choose(test::fraba);
    advance(100);
    QTest::keyClick(&window(), Qt::Key_4, Qt::AltModifier);
    ASSERT_TRUE(viewToPrint(QApplication::focusWidget()));
    EXPECT_EQ(printedValue(QStringLiteral("Position")), "12345 steps");
    QString name;
    const QByteArray pdf = printed(name);
    EXPECT_EQ(name, QStringLiteral("Encoder 1.0"));
    EXPECT_EQ(pdf.count("/Type /Page\n"), 1);
    EXPECT_EQ(pdf.count("/Subtype /Image"), 0) << "no photograph of the screen";
}

TEST_F(PrintingTest, PrintsTheRodWithItsMillimetres)
{
    window().findChild<StructureView *>()->choose("5.0"_ring);
    bus().encoder("5.0"_ring)->tell(Parameter::rodLength, 1000);
    advance(100);
    QTest::mouseClick(window().findChild<RodView *>(), Qt::LeftButton);
    ASSERT_TRUE(viewToPrint(QApplication::focusWidget()));
    EXPECT_THAT(printedValue(QStringLiteral("Position")), HasSubstr(" steps"));
    QString name;
    const QByteArray pdf = printed(name);
    EXPECT_EQ(name, QStringLiteral("Encoder 5.0"));
    EXPECT_EQ(pdf.count("/Type /Page\n"), 1);
    EXPECT_EQ(pdf.count("/Subtype /Image"), 0);
}

TEST_F(PrintingTest, PrintsRulerWordAndTableOfTheCams)
{
    window().findChild<StructureView *>()->choose(test::fraba);
    advance(100);
    actions().cams->trigger();
    const auto view = viewToPrint(QApplication::focusWidget());
    ASSERT_TRUE(view);
    EXPECT_EQ(view->pictures.size(), 2u) << "ruler and word";
    ASSERT_TRUE(view->table);
    EXPECT_NE(qobject_cast<const CamTable *>(view->table.data()), nullptr);
    EXPECT_EQ(printedValue(QStringLiteral("Program")), "1");
    QString name;
    const QByteArray pdf = printed(name);
    EXPECT_EQ(name, QStringLiteral("Cams 1.0"));
    EXPECT_EQ(pdf.count("/Type /Page\n"), 1);
    EXPECT_EQ(pdf.count("/Subtype /Image"), 0);
}

// Entries of the menu that the right button opens there.
QStringList printMenuAt(QWidget &widget)
{
    QStringList entries;
    QTimer::singleShot(0, &widget, [&entries] {
        auto *menu = qobject_cast<QMenu *>(QApplication::activePopupWidget());
        if (menu == nullptr)
            return;
        for (const QAction *action : menu->actions())
            entries << plainLabel(action->text());
        menu->close();
    });
    QContextMenuEvent event(QContextMenuEvent::Mouse, widget.rect().center(),
                            widget.mapToGlobal(widget.rect().center()));
    QApplication::sendEvent(&widget, &event);
    QApplication::processEvents();
    return entries;
}

TEST_F(PrintingTest, TheDialOffersItOnlyWhileItShowsAnEncoder)
{
    auto &dial = *window().findChild<DialPanel *>();
    window().findChild<StructureView *>()->choose(test::fraba);
    advance(100);
    EXPECT_EQ(printMenuAt(dial).constLast(), QStringLiteral("Print…"));
    dial.setEncoder(nullptr);
    EXPECT_EQ(printMenuAt(dial), QStringList());
}

TEST_F(PrintingTest, TicksOfATableArePrinted)
{
    QTableWidget table(1, 1);
    auto *item = new QTableWidgetItem(QStringLiteral("3"));
    item->setCheckState(Qt::Checked);
    table.setItem(0, 0, item);
    EXPECT_TRUE(printedTable(table).contains(QStringLiteral("\u2611 3")));
    item->setCheckState(Qt::Unchecked);
    EXPECT_TRUE(printedTable(table).contains(QStringLiteral("\u2610 3")));
}

TEST_F(PrintingTest, ATableIsPrintedAsItIsShown)
{
    resizeTo({1280, 800}); // the positions are shown
    const auto *tree = window().findChild<QAbstractItemView *>(QStringLiteral("structure"));
    ASSERT_NE(tree, nullptr);
    QTextDocument document;
    document.setHtml(printedHead(QStringLiteral("<Bus>"), QStringLiteral("today")) + printedTable(*tree));
    const std::string text = document.toPlainText().toStdString();
    for (const char *expected : {"<Bus>", "today", "FRABA OCD-IB K3", "12345"})
        EXPECT_THAT(text, HasSubstr(expected));
}

} // namespace
} // namespace codewheel
