// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/buses/mode_switch.h"

#include "widgets/look/grid.h"
#include "widgets/look/label_text.h"
#include "widgets/look/layouts.h"

#include <QAction>
#include <QLabel>
#include <QPainter>
#include <QRadioButton>
#include <QStyleOptionButton>
#include <QStyleOptionFocusRect>

#include <utility>

namespace codewheel {

constexpr int longestName = 120; // pixels

// One side of the switch, for one action.
class ModePart : public QRadioButton
{
public:
    ModePart(QAction &action, QWidget *parent)
        : QRadioButton(plainLabel(action.text()), parent)
        , m_action(action)
    {
        setFocusPolicy(Qt::TabFocus);
        setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
        setIcon(action.icon());
        QObject::connect(this, &QRadioButton::clicked, &action, [&action] {
            if (!action.isChecked())
                action.trigger();
        });
        QObject::connect(&action, &QAction::changed, this, [this] { follow(); });
        follow();
    }

    void tellBus(const QString &name)
    {
        setAccessibleName(name.isEmpty() ? text() : QStringLiteral("%1: %2").arg(name, text()));
    }
    void setWithText(bool with)
    {
        if (std::exchange(m_withText, with) != with)
            updateGeometry();
    }
    QSize sizeWith(bool words) const
    {
        QStyleOptionButton option;
        initStyleOption(&option);
        QSize contents(iconSize().width(), qMax(iconSize().height(), fontMetrics().height()));
        if (words)
            contents.rwidth() += grid::unit + boldMetrics().horizontalAdvance(text());
        return style()
            ->sizeFromContents(QStyle::CT_PushButton, &option, contents + QSize(2 * grid::margin, 0), this)
            .expandedTo(contents + QSize(2 * grid::margin, 2 * grid::unit));
    }
    QSize sizeHint() const override { return sizeWith(m_withText); }
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    bool hitButton(const QPoint &position) const override { return rect().contains(position); }
    void paintEvent(QPaintEvent *) override
    {
        QPainter painter(this);
        const bool isOn = isChecked();
        const QPalette::ColorRole ground = isOn           ? QPalette::Highlight
                                           : underMouse() ? QPalette::Midlight
                                                          : QPalette::Button;
        painter.fillRect(rect(), palette().color(isEnabled() || !isOn ? ground : QPalette::Mid));
        painter.setPen(palette().color(QPalette::Mid));
        painter.drawRect(rect().adjusted(0, 0, -1, -1));
        drawContent(painter, isOn);
        if (hasFocus()) {
            QStyleOptionFocusRect option;
            option.initFrom(this);
            option.rect = rect().adjusted(2, 2, -2, -2);
            option.backgroundColor = palette().color(ground);
            style()->drawPrimitive(QStyle::PE_FrameFocusRect, &option, &painter, this);
        }
    }

private:
    QFontMetrics boldMetrics() const
    {
        QFont bold = font();
        bold.setBold(true);
        return QFontMetrics(bold);
    }
    void drawContent(QPainter &painter, bool isOn) const
    {
        const QSize size = iconSize();
        QRect room = rect().adjusted(grid::margin, 0, -grid::margin, 0);
        const QRect place(QPoint(m_withText ? room.left() : rect().center().x() - size.width() / 2,
                                 rect().center().y() - size.height() / 2),
                          size);
        icon().paint(&painter, place, Qt::AlignCenter,
                     !isEnabled() ? QIcon::Disabled
                     : isOn       ? QIcon::Selected
                                  : QIcon::Normal);
        if (!m_withText)
            return;
        QFont shown = font();
        shown.setBold(isOn);
        painter.setFont(shown);
        painter.setPen(
            palette().color(isOn && isEnabled() ? QPalette::HighlightedText : QPalette::ButtonText));
        room.setLeft(place.right() + grid::unit);
        painter.drawText(room, Qt::AlignCenter, text());
    }
    void follow()
    {
        setEnabled(m_action.isEnabled());
        setToolTip(m_action.toolTip());
        if (m_action.isChecked())
            setChecked(true);
    }

    QAction &m_action;
    bool m_withText = true;
};

ModeSwitch::ModeSwitch(QAction &watch, QAction &operate, QWidget *parent)
    : QWidget(parent)
    , m_name(new QLabel(this))
    , m_watch(new ModePart(watch, this))
    , m_operate(new ModePart(operate, this))
{
    setObjectName(QStringLiteral("modeSwitch"));
    m_watch->setObjectName(QStringLiteral("watch"));
    m_operate->setObjectName(QStringLiteral("operate"));
    m_name->setTextFormat(Qt::PlainText);
    m_name->hide();
    layOutRow(this, {m_name, m_watch, m_operate}, {.spacing = 0, .margins = QMargins(0, 0, grid::margin, 0)});
    tellBus({});
}

void ModeSwitch::tellBus(const QString &name)
{
    const QString text =
        name.isEmpty() ? QString() : m_name->fontMetrics().elidedText(name, Qt::ElideRight, longestName);
    setAccessibleName(tr("Watch or Operate"));
    setAccessibleDescription(name);
    m_name->setToolTip(name);
    m_watch->tellBus(name);
    m_operate->tellBus(name);
    if (text == m_name->text())
        return;
    m_name->setText(text);
    m_name->setContentsMargins(0, 0, text.isEmpty() ? 0 : grid::unit, 0);
    updateGeometry();
}

void ModeSwitch::showOnly(Shown what)
{
    m_name->setVisible(what == Shown::all && !m_name->text().isEmpty());
    m_watch->setWithText(what != Shown::icons);
    m_operate->setWithText(what != Shown::icons);
}

int ModeSwitch::widthOf(Shown what) const
{
    const bool words = what != Shown::icons;
    const int name = what == Shown::all && !m_name->text().isEmpty() ? m_name->sizeHint().width() : 0;
    return name + m_watch->sizeWith(words).width() + m_operate->sizeWith(words).width() + grid::margin;
}

} // namespace codewheel
