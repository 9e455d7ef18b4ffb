// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/instrument_style.h"

#include "widgets/look/grid.h"
#include "widgets/look/roles.h"

#include <QIcon>
#include <QStyle>
#include <QStyleOption>

#include <algorithm>
#include <array>
#include <optional>

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

// The icons of Qt's own dialogs (questions, files, buttons), drawn like those of the window. Nothing: use
// Qt's own. Called by InstrumentStyle.
std::optional<QIcon> standardLineIcon(QStyle::StandardPixmap which)
{
    if (which == QStyle::SP_MessageBoxWarning)
        return lineIcon(Icon::attention, Role::attention);
    if (which == QStyle::SP_MessageBoxCritical)
        return lineIcon(Icon::fault, Role::fault);
    const auto *found = std::ranges::find(standardIcons, which, &StandardIcon::which);
    return found == standardIcons.end() ? std::nullopt : std::optional(lineIcon(found->icon));
}

constexpr int longestMotion = 200; // ms
constexpr int headingInset = 2; // beyond Fusion's: headings stand apart, and above the texts of their column

// What a gloved finger has to hit.
bool isControlMetric(QStyle::PixelMetric metric)
{
    switch (metric) {
    case QStyle::PM_IndicatorWidth:
    case QStyle::PM_IndicatorHeight:
    case QStyle::PM_ExclusiveIndicatorWidth:
    case QStyle::PM_ExclusiveIndicatorHeight:
    case QStyle::PM_ScrollBarExtent:
    case QStyle::PM_SliderThickness:
    case QStyle::PM_SliderLength:
    case QStyle::PM_SplitterWidth:
    case QStyle::PM_ButtonIconSize:
    case QStyle::PM_TabCloseIndicatorWidth:
    case QStyle::PM_TabCloseIndicatorHeight:
        return true;
    default:
        return false;
    }
}

// All of the same height, with and without an icon. A spin box is as high as the line edit in it.
bool isControl(QStyle::ContentsType type)
{
    switch (type) {
    case QStyle::CT_PushButton:
    case QStyle::CT_ToolButton:
    case QStyle::CT_ComboBox:
    case QStyle::CT_LineEdit:
    case QStyle::CT_CheckBox:
    case QStyle::CT_RadioButton:
    case QStyle::CT_MenuItem:
    case QStyle::CT_MenuBarItem:
    case QStyle::CT_TabBarTab:
    case QStyle::CT_ItemViewItem:
    case QStyle::CT_HeaderSection:
        return true;
    default:
        return false;
    }
}

// Fusion derives the rims of fields and boxes from the window's background, which leaves them hard to see on
// a dark one. It divides what it is given by 1.4, so this yields the rim of an unset bit.
void setRim(QPalette &palette)
{
    palette.setColor(QPalette::Window, roleColor(Role::inactive, palette).lighter(140));
}

constexpr int larger(int length)
{
    return length + length / 2;
}

} // namespace

InstrumentStyle::InstrumentStyle(bool largeControls, bool lessMotion)
    : QProxyStyle(QStringLiteral("Fusion"))
    , m_largeControls(largeControls)
    , m_lessMotion(lessMotion)
{}

int InstrumentStyle::styleHint(StyleHint hint, const QStyleOption *option, const QWidget *widget,
                               QStyleHintReturn *returned) const
{
    if (hint == largeControlsHint)
        return m_largeControls ? 1 : 0;
    const int usual = QProxyStyle::styleHint(hint, option, widget, returned);
    if (hint == SH_Widget_Animation_Duration)
        return m_lessMotion ? 0 : qMin(usual, longestMotion);
    return usual;
}

int InstrumentStyle::pixelMetric(PixelMetric metric, const QStyleOption *option, const QWidget *widget) const
{
    switch (metric) {
    case PM_LayoutLeftMargin:
    case PM_LayoutTopMargin:
    case PM_LayoutRightMargin:
    case PM_LayoutBottomMargin:
        return grid::margin;
    case PM_LayoutHorizontalSpacing:
    case PM_LayoutVerticalSpacing:
        return grid::unit;
    case PM_TabBarTabHSpace:
        return 2 * grid::margin;
    case PM_SmallIconSize:
    case PM_ToolBarIconSize:
        return m_largeControls ? larger(grid::smallIcon) : grid::smallIcon;
    default:
        break;
    }
    const int usual = QProxyStyle::pixelMetric(metric, option, widget);
    return m_largeControls && isControlMetric(metric) ? larger(usual) : usual;
}

void InstrumentStyle::drawPrimitive(PrimitiveElement element, const QStyleOption *option, QPainter *painter,
                                    const QWidget *widget) const
{
    const auto drawWithRim = [&](auto copy) {
        setRim(copy.palette);
        QProxyStyle::drawPrimitive(element, &copy, painter, widget);
    };
    switch (element) {
    case PE_IndicatorCheckBox:
    case PE_IndicatorRadioButton:
        if (const auto *button = qstyleoption_cast<const QStyleOptionButton *>(option))
            return drawWithRim(*button);
        break;
    case PE_PanelLineEdit:
    case PE_FrameLineEdit:
        if (const auto *frame = qstyleoption_cast<const QStyleOptionFrame *>(option))
            return drawWithRim(*frame);
        break;
    default:
        break;
    }
    QProxyStyle::drawPrimitive(element, option, painter, widget);
}

void InstrumentStyle::drawComplexControl(ComplexControl control, const QStyleOptionComplex *option,
                                         QPainter *painter, const QWidget *widget) const
{
    const auto *box = qstyleoption_cast<const QStyleOptionSpinBox *>(option);
    if (box == nullptr)
        return QProxyStyle::drawComplexControl(control, option, painter, widget);
    QStyleOptionSpinBox copy = *box;
    setRim(copy.palette);
    QProxyStyle::drawComplexControl(control, &copy, painter, widget);
}

// Not by SE_HeaderLabel: Fusion does not ask its proxy for it.
void InstrumentStyle::drawControl(ControlElement element, const QStyleOption *option, QPainter *painter,
                                  const QWidget *widget) const
{
    const auto drawInset = [&](auto copy) {
        copy.rect.adjust(headingInset, 0, -headingInset, 0);
        QProxyStyle::drawControl(element, &copy, painter, widget);
    };
    if (element == CE_HeaderLabel) {
        if (const auto *newer = qstyleoption_cast<const QStyleOptionHeaderV2 *>(option))
            return drawInset(*newer);
        if (const auto *heading = qstyleoption_cast<const QStyleOptionHeader *>(option))
            return drawInset(*heading);
    }
    QProxyStyle::drawControl(element, option, painter, widget);
}

QSize InstrumentStyle::sizeFromContents(ContentsType type, const QStyleOption *option, const QSize &contents,
                                        const QWidget *widget) const
{
    QSize size = QProxyStyle::sizeFromContents(type, option, contents, widget);
    if (type == CT_HeaderSection)
        size.rwidth() += 2 * headingInset;
    if (m_largeControls && option != nullptr && isControl(type))
        size.setHeight(qMax(size.height(), larger(option->fontMetrics.height() + 2 * grid::unit)));
    return size;
}

QIcon InstrumentStyle::standardIcon(StandardPixmap which, const QStyleOption *option,
                                    const QWidget *widget) const
{
    const auto ours = standardLineIcon(which);
    return ours ? *ours : QProxyStyle::standardIcon(which, option, widget);
}

} // namespace codewheel
