// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/appearance.h"
#include "widgets/look/icons.h"

#include <QApplication>
#include <QIcon>
#include <QImage>
#include <QPalette>
#include <QPixmap>
#include <QRgb>
#include <QSet>
#include <QSize>
#include <QStyle>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

// The colours of all fully covered pixels; drawn large, since a thin diagonal line covers none.
QSet<QRgb> inks(const QIcon &icon, QIcon::Mode mode = QIcon::Normal)
{
    const QImage image =
        icon.pixmap(QSize(24, 24), 4.0, mode).toImage().convertToFormat(QImage::Format_ARGB32);
    QSet<QRgb> found;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            if (qAlpha(image.pixel(x, y)) == 255)
                found.insert(image.pixel(x, y));
    return found;
}

class Icons : public testing::Test
{
protected:
    ~Icons() override { applyAppearance(*qApp, {.scheme = Scheme::light}); }
};

TEST_F(Icons, EachIsDrawnInTheTextColour)
{
    for (const Scheme scheme : {Scheme::light, Scheme::dark}) {
        applyAppearance(*qApp, {.scheme = scheme});
        for (int i = 0; i < iconCount; ++i)
            EXPECT_EQ(inks(lineIcon(static_cast<Icon>(i))), QSet{qApp->palette().windowText().color().rgba()})
                << "icon " << i;
    }
}

TEST_F(Icons, AnIconMadeBeforeTheSchemeChangesFollowsIt)
{
    const QIcon icon = lineIcon(Icon::start);
    const auto light = inks(icon);
    applyAppearance(*qApp, {.scheme = Scheme::dark});
    EXPECT_NE(inks(icon), light);
}

TEST_F(Icons, ADisabledOneIsPaler)
{
    EXPECT_EQ(inks(lineIcon(Icon::start), QIcon::Disabled),
              QSet{qApp->palette().color(QPalette::Disabled, QPalette::WindowText).rgba()});
}

TEST_F(Icons, ARolesIconHasItsColour)
{
    for (const Role role : allRoles)
        EXPECT_EQ(inks(lineIcon(roleIcon(role), role)), QSet{roleColor(role, qApp->palette()).rgba()});
}

TEST_F(Icons, AreCrispOnADenseScreen)
{
    const QPixmap pixmap = lineIcon(Icon::start).pixmap(QSize(16, 16), 2.0);
    EXPECT_EQ(pixmap.size(), QSize(32, 32));
    EXPECT_EQ(pixmap.devicePixelRatio(), 2.0);
}

// The icons of a question, a file dialog and their buttons.
TEST_F(Icons, QtsDialogsShowThoseOfTheSet)
{
    applyAppearance(*qApp, {.scheme = Scheme::dark});
    for (const auto which :
         {QStyle::SP_MessageBoxQuestion, QStyle::SP_MessageBoxInformation, QStyle::SP_DialogSaveButton,
          QStyle::SP_DialogOpenButton, QStyle::SP_DialogCancelButton, QStyle::SP_FileDialogToParent,
          QStyle::SP_FileDialogNewFolder, QStyle::SP_FileDialogListView, QStyle::SP_FileDialogDetailedView,
          QStyle::SP_ArrowBack, QStyle::SP_ArrowForward, QStyle::SP_DirIcon, QStyle::SP_FileIcon,
          QStyle::SP_DirHomeIcon, QStyle::SP_ComputerIcon, QStyle::SP_DriveHDIcon})
        EXPECT_EQ(inks(qApp->style()->standardIcon(which)), QSet{qApp->palette().windowText().color().rgba()})
            << which;
    EXPECT_EQ(inks(qApp->style()->standardIcon(QStyle::SP_MessageBoxWarning)),
              QSet{roleColor(Role::attention, qApp->palette()).rgba()});
    EXPECT_EQ(inks(qApp->style()->standardIcon(QStyle::SP_MessageBoxCritical)),
              QSet{roleColor(Role::fault, qApp->palette()).rgba()});
}

} // namespace
} // namespace codewheel
