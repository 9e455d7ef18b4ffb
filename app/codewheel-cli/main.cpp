// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/call/command_line.h"
#include "cli/call/terminal.h"
#include "journal/ledger_writer.h"
#include "journal_files.h"
#include "language.h"
#include "standard_streams.h"

#include <QGuiApplication>
#include <QLocale>
#include <QSettings>

#include <iostream>
#include <memory>
#include <unistd.h>

namespace codewheel {
namespace {

QtMessageHandler usualHandler = nullptr;

// Qt warns about folders that exist only for users logged in at a desktop.
void dropWarnings(QtMsgType type, const QMessageLogContext &context, const QString &text)
{
    if (type != QtWarningMsg)
        usualHandler(type, context, text);
}

std::unique_ptr<QCoreApplication> makeWithFonts(int &argc, char **argv)
{
    qputenv("QT_QPA_PLATFORM", "offscreen");
    usualHandler = qInstallMessageHandler(dropWarnings);
    auto application = std::make_unique<QGuiApplication>(argc, argv);
    qInstallMessageHandler(usualHandler);
    return application;
}

QStringList wordsOf(int argc, char **argv)
{
    QStringList words;
    for (int i = 1; i < argc; ++i)
        words << QString::fromLocal8Bit(argv[i]);
    return words;
}

// The Qt application the program needs. For a PDF it has fonts, but neither looks for a screen nor needs one.
std::unique_ptr<QCoreApplication> makeApplication(int &argc, char **argv)
{
    if (makesPdf(wordsOf(argc, argv)))
        return makeWithFonts(argc, argv);
    return std::make_unique<QCoreApplication>(argc, argv);
}

} // namespace
} // namespace codewheel

int main(int argc, char **argv)
{
    codewheel::prepareStandardStreams();
    const auto application = codewheel::makeApplication(argc, argv);

    codewheel::Language language;
    language.use(QString()); // the system's

    // What is printed can be typed in again: digits 0 to 9, numbers without group separators.
    QLocale locale = QLocale().zeroDigit() == QStringLiteral("0") ? QLocale() : QLocale::c();
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    QLocale::setDefault(locale);

    codewheel::setLedgerUser(codewheel::userName(*codewheel::userSettings()));
    const bool isInteractive = isatty(STDIN_FILENO) == 1 && isatty(STDOUT_FILENO) == 1;
    const codewheel::Terminal terminal{std::cin, std::cout, std::cerr, isInteractive, STDIN_FILENO};
    return codewheel::runCommandLine(QCoreApplication::arguments().sliced(1), terminal);
}
