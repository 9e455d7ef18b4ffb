// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/alarm_stop.h"

#include "widgets/look/roles.h"

#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QGridLayout>
#include <QKeyEvent>
#include <QToolButton>

namespace codewheel {
namespace {

// Painted by the palette, so that light and dark and the contrast of the role hold.
class AlarmStopButton : public QToolButton
{
public:
    AlarmStopButton(QAction *action, QWidget *parent)
        : QToolButton(parent)
    {
        setObjectName(QStringLiteral("alarmStop"));
        setDefaultAction(action);
        setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        setFocusPolicy(Qt::TabFocus);
        const auto showName = [this, action] { setAccessibleName(action->text().remove(u'&')); };
        QObject::connect(action, &QAction::changed, this, showName);
        showName();
        color();
    }

protected:
    void changeEvent(QEvent *event) override
    {
        QToolButton::changeEvent(event);
        if (event->type() == QEvent::StyleChange || event->type() == QEvent::ApplicationPaletteChange)
            color();
    }

private:
    void color()
    {
        const QPalette general = QApplication::palette();
        const QString sheet =
            QStringLiteral("QToolButton { background: %1; color: %2; border: 1px solid %1;"
                           " border-radius: 4px; padding: 4px 10px; font-weight: bold; }"
                           "QToolButton:focus, QToolButton:hover { border-color: %2; }")
                .arg(roleColor(Role::fault, general).name(), textOn(Role::fault, general).name());
        if (sheet != styleSheet())
            setStyleSheet(sheet);
    }
};

} // namespace

QKeySequence alarmStopKey()
{
    return Qt::CTRL | Qt::Key_F12;
}

QWidget *makeAlarmStopButton(QAction *alarmStop, QWidget *parent)
{
    return new AlarmStopButton(alarmStop, parent);
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
    if (event->type() == QEvent::Show)
        if (auto *dialog = qobject_cast<QDialog *>(watched); dialog != nullptr && dialog->isModal())
            addButton(*dialog);
    return QObject::eventFilter(watched, event);
}

void AlarmStopEverywhere::addButton(QWidget &dialog)
{
    if (dialog.layout() == nullptr || dialog.findChild<QToolButton *>(QStringLiteral("alarmStop")) != nullptr)
        return;
    QWidget *button = makeAlarmStopButton(&m_alarmStop, &dialog);
    if (auto *grid = qobject_cast<QGridLayout *>(dialog.layout()))
        grid->addWidget(button, grid->rowCount(), 0, 1, -1, Qt::AlignLeft);
    else
        dialog.layout()->addWidget(button);
}

} // namespace codewheel
