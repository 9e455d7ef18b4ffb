// SPDX-License-Identifier: GPL-3.0-or-later
// main() of the test programs with widgets: our light palette on the offscreen platform.
#include "widgets/look/appearance.h"

#include <QApplication>
#include <QLocale>

#include <gtest/gtest.h>

namespace {

// A program under test may have chosen another language: each test starts without one.
class NoLanguage final : public testing::EmptyTestEventListener
{
    void OnTestStart(const testing::TestInfo &) override { QLocale::setDefault(QLocale::c()); }
};

QtMessageHandler usualHandler = nullptr;

// The offscreen platform says this of each window it shows: thousands of lines that hide a failure.
void dropSizeHints(QtMsgType type, const QMessageLogContext &context, const QString &text)
{
    if (text != QLatin1String("This plugin does not support propagateSizeHints()"))
        usualHandler(type, context, text);
}

} // namespace

int main(int argc, char **argv)
{
    usualHandler = qInstallMessageHandler(dropSizeHints);
    QApplication application(argc, argv);
    codewheel::applyAppearance(application, {.scheme = codewheel::Scheme::light});
    QApplication::setDoubleClickInterval(0); // what has just come is clicked at once (InlineMessage)
    testing::InitGoogleTest(&argc, argv);
    testing::UnitTest::GetInstance()->listeners().Append(new NoLanguage); // takes ownership
    return RUN_ALL_TESTS();
}
