// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/program.h"
#include "language.h"
#include "standard_streams.h"
#include "vocabulary/shown_text.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QIcon>

#include <algorithm>
#include <cerrno>
#include <iostream>
#include <string_view>

namespace {

void name(QCoreApplication &application)
{
    application.setApplicationName(QStringLiteral("codewheel"));
    application.setApplicationVersion(QStringLiteral(CODEWHEEL_VERSION));
}

void describe(QCommandLineParser &parser)
{
    parser.setApplicationDescription(QCoreApplication::translate(
        "codewheel",
        "Sets up, watches and diagnoses absolute encoders on INTERBUS, CANopen and serial lines."));
    parser.addHelpOption();
    parser.addVersionOption();
    parser.addPositionalArgument(
        QStringLiteral("FILE"),
        QCoreApplication::translate("codewheel", "A project to open: *.codewheel, a recording: *.cwrec, "
                                                 "cams: *.cwcams, a fault plan: *.cwfaults, or a "
                                                 "device description or sequence: *.json"),
        QStringLiteral("[FILE]"));
}

bool asksForText(int argc, char **argv)
{
    return std::any_of(argv + 1, argv + argc, [](std::string_view argument) {
        return argument == "-h" || argument == "--help" || argument == "--help-all" || argument == "-v" ||
               argument == "--version";
    });
}

int complain(const QString &text)
{
    std::cerr << "codewheel: " << codewheel::shownText(text).toStdString() << std::endl;
    return EXIT_FAILURE;
}

// Help and version, which also work without a screen.
int tell(int argc, char **argv)
{
    QCoreApplication application(argc, argv);
    name(application);
    codewheel::Language language;
    language.use({});
    QCommandLineParser parser;
    describe(parser);
    if (!parser.parse(QCoreApplication::arguments()))
        return complain(parser.errorText());
    const QString version =
        QCoreApplication::applicationName() + u' ' + QCoreApplication::applicationVersion() + u'\n';
    const bool isVersion = parser.isSet(QStringLiteral("version"));
    errno = 0;
    std::cout << (isVersion ? version : parser.helpText()).toStdString() << std::flush;
    if (std::cout)
        return EXIT_SUCCESS;
    return complain(QCoreApplication::translate("codewheel", "Standard output cannot be written: %1.")
                        .arg(qt_error_string(errno)));
}

} // namespace

int main(int argc, char **argv)
{
    codewheel::prepareStandardStreams();
    if (asksForText(argc, argv))
        return tell(argc, argv);
    QApplication::setAttribute(Qt::AA_DontUseNativeDialogs); // each of our own dialogs has ALARM STOP
    QApplication application(argc, argv);
    name(application);
    QApplication::setApplicationDisplayName(QStringLiteral("Codewheel"));
    QApplication::setDesktopFileName(QStringLiteral("io.codewheel.Codewheel"));
    QApplication::setWindowIcon(QIcon(QStringLiteral(":/program/io.codewheel.Codewheel.svg")));

    codewheel::Program program(application);
    QCommandLineParser parser;
    describe(parser);
    if (!parser.parse(QApplication::arguments()))
        return complain(parser.errorText());
    program.openAtStart(parser.positionalArguments().value(0));
    return program.run();
}
