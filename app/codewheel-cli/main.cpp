// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/call/command_line.h"
#include "cli/call/terminal.h"
#include "codewheel-cli/application.h"
#include "journal/ledger_writer.h"
#include "journal_files.h"
#include "language.h"
#include "standard_streams.h"

#include <QCoreApplication>
#include <QLocale>
#include <QSettings>

#include <iostream>
#include <unistd.h>

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
