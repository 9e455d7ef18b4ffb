// SPDX-License-Identifier: GPL-3.0-or-later
// main() of the test programs that have widgets: our light look on the offscreen platform.
#include "widgets/look/appearance.h"

#include <QApplication>
#include <QLocale>

#include <gtest/gtest.h>

int main(int argc, char **argv)
{
    QApplication application(argc, argv);
    QLocale::setDefault(QLocale::c());
    codewheel::applyAppearance(application, {.scheme = codewheel::Scheme::light});
    testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
