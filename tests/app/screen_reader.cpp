// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/screen_reader.h"

#include <QAbstractEventDispatcher>
#include <QAccessible>
#include <QCoreApplication>
#include <QSignalSpy>
#include <QTimerEvent>
#include <QWidget>

#include <gtest/gtest.h>

namespace codewheel::test {
namespace {

QAccessibleInterface *findIn(QAccessibleInterface *in, QAccessible::Role role, const QString &name)
{
    if (in == nullptr || in->state().invisible)
        return nullptr;
    if (in->role() == role && in->text(QAccessible::Name) == name)
        return in;
    for (int i = 0; i < in->childCount(); ++i)
        if (QAccessibleInterface *found = findIn(in->child(i), role, name))
            return found;
    return nullptr;
}

// For a tenth of a second a button looks pressed, using its only timer: ends that time now.
void endShownPress(QObject &button)
{
    for (const auto &timer : QAbstractEventDispatcher::instance()->registeredTimers(&button)) {
        QTimerEvent over(timer.timerId);
        QCoreApplication::sendEvent(&button, &over);
    }
}

} // namespace

ScreenReader::ScreenReader(QWidget &window)
    : m_window(window)
{}

QAccessibleInterface *ScreenReader::find(QAccessible::Role role, const QString &name) const
{
    QAccessibleInterface *found = findIn(QAccessible::queryAccessibleInterface(&m_window), role, name);
    EXPECT_NE(found, nullptr) << "nothing is called " << name.toStdString();
    return found;
}

// Most buttons look pressed first, and emit their click after that.
void ScreenReader::press(const QString &name) const
{
    QAccessibleInterface *found = find(QAccessible::Button, name);
    ASSERT_NE(found, nullptr);
    ASSERT_FALSE(found->state().disabled) << name.toStdString();
    ASSERT_NE(found->actionInterface(), nullptr) << name.toStdString();
    QSignalSpy clicked(found->object(), SIGNAL(clicked(bool)));
    found->actionInterface()->doAction(QAccessibleActionInterface::pressAction());
    if (clicked.count() == 0)
        endShownPress(*found->object());
    EXPECT_EQ(clicked.count(), 1) << name.toStdString();
}

void ScreenReader::toggle(const QString &name) const
{
    QAccessibleInterface *found = find(QAccessible::CheckBox, name);
    ASSERT_NE(found, nullptr);
    found->actionInterface()->doAction(QAccessibleActionInterface::toggleAction());
}

bool ScreenReader::isChecked(const QString &name) const
{
    QAccessibleInterface *found = find(QAccessible::CheckBox, name);
    return found != nullptr && found->state().checked;
}

void ScreenReader::type(const QString &name, const QString &text) const
{
    QAccessibleInterface *found = find(QAccessible::EditableText, name);
    ASSERT_NE(found, nullptr);
    found->setText(QAccessible::Value, text);
}

QString ScreenReader::read(const QString &name) const
{
    QAccessibleInterface *found = find(QAccessible::EditableText, name);
    return found == nullptr ? QString() : found->text(QAccessible::Value);
}

} // namespace codewheel::test
