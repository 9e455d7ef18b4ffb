// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/printed_table.h"
#include "app/window/printing.h"
#include "tests/app/question.h"
#include "tests/app/window_test.h"
#include "widgets/messages/messages_view.h"

#include <QAction>
#include <QFile>
#include <QPrinter>
#include <QPrintPreviewDialog>
#include <QTableView>
#include <QTextDocument>

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

TEST_F(PrintingTest, ATableIsPrintedAsItIsShown)
{
    const auto *tree = window().findChild<QAbstractItemView *>(QStringLiteral("busTree"));
    const auto *shownTree = tree != nullptr ? tree : tableToPrint(QApplication::focusWidget());
    ASSERT_NE(shownTree, nullptr);
    QTextDocument document;
    document.setHtml(printedTable(*shownTree, QStringLiteral("<Bus>"), QStringLiteral("today")));
    const std::string text = document.toPlainText().toStdString();
    for (const char *expected : {"<Bus>", "today", "FRABA OCD-IB K3", "12345"})
        EXPECT_THAT(text, HasSubstr(expected));
}

} // namespace
} // namespace codewheel
