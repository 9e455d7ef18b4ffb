// SPDX-License-Identifier: GPL-3.0-or-later
// codewheel-screenshots FOLDER [LANGUAGE [review]]: makes the pictures of the manual from the training bus in
// virtual time, light and dark; with "review", every view in the whole window, in three sizes. Two runs give
// the same files.
#include "app/language.h"
#include "app/screenshots/manual_pictures.h"

#include <QApplication>
#include <QDir>

#include <cstdio>

int main(int argc, char **argv)
{
    qputenv("TZ", "UTC"); // the same time everywhere
    QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    QApplication application(argc, argv);
    QApplication::setApplicationDisplayName(QStringLiteral("Codewheel"));
    QApplication::setApplicationVersion(QStringLiteral(CODEWHEEL_VERSION));
    const QStringList arguments = QApplication::arguments();
    if (arguments.size() < 2 || !QDir().mkpath(arguments.at(1))) {
        std::fprintf(stderr, "codewheel-screenshots: name a folder that can be written to\n");
        return 2;
    }
    codewheel::Language language;
    language.use(arguments.value(2, QStringLiteral("en")));
    const bool forReview = arguments.value(3) == QStringLiteral("review");
    const auto make = forReview ? codewheel::makeReviewPictures : codewheel::makeManualPictures;
    return make(application, QDir(arguments.at(1))) ? 0 : 1;
}
