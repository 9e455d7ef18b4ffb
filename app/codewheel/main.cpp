// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/program.h"

#include <QApplication>

int main(int argc, char **argv)
{
    QApplication::setAttribute(Qt::AA_DontUseNativeDialogs); // each of ours carries ALARM STOP
    QApplication application(argc, argv);
    QApplication::setApplicationName(QStringLiteral("codewheel"));
    QApplication::setApplicationDisplayName(QStringLiteral("Codewheel"));
    QApplication::setApplicationVersion(QStringLiteral(CODEWHEEL_VERSION));
    QApplication::setDesktopFileName(QStringLiteral("codewheel"));

    codewheel::Program program(application);
    program.openAtStart(QCoreApplication::arguments().value(1));
    return program.run();
}
