// SPDX-License-Identifier: GPL-3.0-or-later
#include "codewheel-cli/application.h"

#include "cli/call/command_line.h"

#include <QGuiApplication>

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

} // namespace

std::unique_ptr<QCoreApplication> makeApplication(int &argc, char **argv)
{
    if (makesPdf(wordsOf(argc, argv)))
        return makeWithFonts(argc, argv);
    return std::make_unique<QCoreApplication>(argc, argv);
}

} // namespace codewheel
