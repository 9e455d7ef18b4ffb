// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/buses/alarm_stop.h"

#include "widgets/look/grid.h"
#include "widgets/look/label_text.h"

#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QFileDialog>
#include <QGridLayout>
#include <QKeyEvent>
#include <QStyleOptionToolButton>
#include <QToolButton>

#include <algorithm>

namespace codewheel {
namespace {

// The same in light and dark, so that it is always this red one looks for. Derived from the fault colour,
// with a lightness between both backgrounds, so that the button has a contrast of 3 : 1 with either, and
// white on it 4.5 : 1.
constexpr QRgb red = 0xFFC84300;

class AlarmStopButton : public QToolButton
{
public:
    AlarmStopButton(QAction *action, AlarmStopWeight weight, QWidget *parent)
        : QToolButton(parent)
        , m_isFilled(weight == AlarmStopWeight::filled)
    {
        setObjectName(QStringLiteral("alarmStop"));
        setDefaultAction(action);
        setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        setFocusPolicy(Qt::TabFocus);
        const auto showName = [this, action] { setAccessibleName(plainLabel(action->text())); };
        QObject::connect(action, &QAction::changed, this, showName);
        showName();
        setStyleSheet(m_isFilled ? filledSheet() : rimSheet());
    }

protected:
    // In the colour of the text, which on the red is that of selected text: white.
    void initStyleOption(QStyleOptionToolButton *option) const override
    {
        QToolButton::initStyleOption(option);
        if (m_isFilled && isEnabled())
            option->icon = QIcon(option->icon.pixmap(option->iconSize, devicePixelRatioF(), QIcon::Selected));
    }

private:
    static QString filledSheet()
    {
        return QStringLiteral("QToolButton { background: %1; color: white; border: 2px solid %1;"
                              " border-radius: 4px; padding: 4px 10px; font-weight: bold; }"
                              "QToolButton:focus, QToolButton:hover { border-color: palette(window-text); }"
                              "QToolButton:disabled { background: palette(mid); color: palette(window-text);"
                              " border-color: palette(mid); }")
            .arg(QColor::fromRgb(red).name());
    }
    static QString rimSheet()
    {
        return QStringLiteral("QToolButton { border: 1px solid %1; border-radius: 4px; padding: 4px 10px; }"
                              "QToolButton:focus, QToolButton:hover { border-color: palette(window-text); }")
            .arg(QColor::fromRgb(red).name());
    }

    const bool m_isFilled;
};

} // namespace

QKeySequence alarmStopKey()
{
    return Qt::CTRL | Qt::Key_F12;
}

QWidget *makeAlarmStopButton(QAction *alarmStop, QWidget *parent, AlarmStopWeight weight)
{
    return new AlarmStopButton(alarmStop, weight, parent);
}

AlarmStopEverywhere::AlarmStopEverywhere(QAction &alarmStop, QObject *parent)
    : QObject(parent)
    , m_alarmStop(alarmStop)
{
    qApp->installEventFilter(this);
}

AlarmStopEverywhere::~AlarmStopEverywhere()
{
    qApp->removeEventFilter(this);
}

bool AlarmStopEverywhere::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::KeyPress && QApplication::activeModalWidget() != nullptr) {
        const auto *key = static_cast<QKeyEvent *>(event);
        if (QKeySequence(key->keyCombination()) == alarmStopKey()) {
            m_alarmStop.trigger();
            return true;
        }
    }
    if (event->type() == QEvent::Show || event->type() == QEvent::LayoutRequest)
        if (auto *dialog = qobject_cast<QDialog *>(watched);
            dialog != nullptr && dialog->isModal() && dialog->isVisible())
            addButton(*dialog);
    return QObject::eventFilter(watched, event);
}

// A question of Qt's makes its layout anew when the style changes: the button is put into that, too.
void AlarmStopEverywhere::addButton(QWidget &dialog)
{
    QWidget *button = dialog.findChild<QToolButton *>(QStringLiteral("alarmStop"));
    if (dialog.layout() == nullptr || (button != nullptr && dialog.layout()->indexOf(button) >= 0))
        return;
    const bool isOfFiles =
        qobject_cast<QFileDialog *>(&dialog) != nullptr; // there, Save is what one came for
    if (button == nullptr)
        button = makeAlarmStopButton(&m_alarmStop, &dialog,
                                     isOfFiles ? AlarmStopWeight::rim : AlarmStopWeight::filled);
    if (auto *cells = qobject_cast<QGridLayout *>(dialog.layout())) {
        const int below = cells->rowCount();
        cells->setRowMinimumHeight(below, grid::margin); // apart from the answers
        cells->addWidget(button, below + 1, 0, 1, -1, Qt::AlignLeft);
    } else {
        dialog.layout()->addWidget(button);
    }
    button->show(); // a layout would do so later, at the cost of the texts
    if (dialog.layout()->hasHeightForWidth())
        dialog.resize(dialog.width(),
                      std::max(dialog.height(), dialog.layout()->totalHeightForWidth(dialog.width())));
}

} // namespace codewheel
