// SPDX-License-Identifier: GPL-3.0-or-later
// codewheel-screenshots FOLDER [LANGUAGE [review|trees]]: makes the pictures of the manual from the training
// bus in virtual time, light and dark; with "review", every view in the whole window, in three sizes; with
// "trees", every view as a screen reader tells it. Two runs give the same files.
#include "app/language.h"
#include "app/screenshots/kinds/manual_pictures.h"

#include <QApplication>
#include <QDir>

#include <cstdio>

int main(int argc, char **argv)
{
    qputenv("TZ", "UTC"); // the same time everywhere
    QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    QApplication application(argc, argv);
    QApplication::setDoubleClickInterval(0); // a page that has just come is clicked at once
    QApplication::setApplicationDisplayName(QStringLiteral("Codewheel"));
    QApplication::setApplicationVersion(QStringLiteral(CODEWHEEL_VERSION));
    const QStringList arguments = QApplication::arguments();
    if (arguments.size() < 2 || !QDir().mkpath(arguments.at(1))) {
        std::fprintf(stderr, "codewheel-screenshots: name a folder that can be written to\n");
        return 2;
    }
    codewheel::Language language;
    language.use(arguments.value(2, QStringLiteral("en")));
    const QDir folder(arguments.at(1));
    const QString what = arguments.value(3);
    const bool isMade = what == QStringLiteral("trees") ? codewheel::makeAccessibleTrees(folder)
                        : what == QStringLiteral("review")
                            ? codewheel::makeReviewPictures(application, folder)
                            : codewheel::makeManualPictures(application, folder);
    return isMade ? 0 : 1;
}
