// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/standard_icons.h"

#include "widgets/look/roles.h"

#include <QIcon>

#include <algorithm>
#include <array>

namespace codewheel {
namespace {

struct StandardIcon
{
    QStyle::StandardPixmap which;
    Icon icon;
};

constexpr std::array standardIcons{
    StandardIcon{QStyle::SP_MessageBoxQuestion, Icon::question},
    StandardIcon{QStyle::SP_MessageBoxInformation, Icon::information},
    StandardIcon{QStyle::SP_DialogOkButton, Icon::ok},
    StandardIcon{QStyle::SP_DialogYesButton, Icon::ok},
    StandardIcon{QStyle::SP_DialogApplyButton, Icon::ok},
    StandardIcon{QStyle::SP_DialogCancelButton, Icon::cancel},
    StandardIcon{QStyle::SP_DialogNoButton, Icon::cancel},
    StandardIcon{QStyle::SP_DialogCloseButton, Icon::cancel},
    StandardIcon{QStyle::SP_DialogDiscardButton, Icon::remove},
    StandardIcon{QStyle::SP_DialogResetButton, Icon::refresh},
    StandardIcon{QStyle::SP_DialogRetryButton, Icon::refresh},
    StandardIcon{QStyle::SP_DialogHelpButton, Icon::question},
    StandardIcon{QStyle::SP_DialogOpenButton, Icon::open},
    StandardIcon{QStyle::SP_DialogSaveButton, Icon::save},
    StandardIcon{QStyle::SP_DialogSaveAllButton, Icon::save},
    StandardIcon{QStyle::SP_ArrowBack, Icon::back},
    StandardIcon{QStyle::SP_FileDialogBack, Icon::back},
    StandardIcon{QStyle::SP_ArrowForward, Icon::next},
    StandardIcon{QStyle::SP_FileDialogToParent, Icon::up},
    StandardIcon{QStyle::SP_FileDialogNewFolder, Icon::newFolder},
    StandardIcon{QStyle::SP_FileDialogListView, Icon::list},
    StandardIcon{QStyle::SP_FileDialogDetailedView, Icon::details},
    StandardIcon{QStyle::SP_DirIcon, Icon::folder},
    StandardIcon{QStyle::SP_DirClosedIcon, Icon::folder},
    StandardIcon{QStyle::SP_DirOpenIcon, Icon::open},
    StandardIcon{QStyle::SP_DirLinkIcon, Icon::folder},
    StandardIcon{QStyle::SP_DirHomeIcon, Icon::home},
    StandardIcon{QStyle::SP_DesktopIcon, Icon::computer},
    StandardIcon{QStyle::SP_ComputerIcon, Icon::computer},
    StandardIcon{QStyle::SP_DriveHDIcon, Icon::drive},
    StandardIcon{QStyle::SP_DriveNetIcon, Icon::drive},
    StandardIcon{QStyle::SP_FileIcon, Icon::file},
    StandardIcon{QStyle::SP_FileLinkIcon, Icon::file},
};

} // namespace

std::optional<QIcon> standardLineIcon(QStyle::StandardPixmap which)
{
    if (which == QStyle::SP_MessageBoxWarning)
        return lineIcon(Icon::attention, Role::attention);
    if (which == QStyle::SP_MessageBoxCritical)
        return lineIcon(Icon::fault, Role::fault);
    const auto *found = std::ranges::find(standardIcons, which, &StandardIcon::which);
    return found == standardIcons.end() ? std::nullopt : std::optional(lineIcon(found->icon));
}

} // namespace codewheel
