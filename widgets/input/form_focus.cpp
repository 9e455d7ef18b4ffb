// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/input/form_focus.h"

#include <QApplication>
#include <QDockWidget>
#include <QStackedWidget>

#include <utility>

namespace codewheel {
namespace {

// The outermost page or panel within its window; otherwise the window.
const QWidget *formOf(const QWidget &part)
{
    const QWidget *form = part.window();
    for (const QWidget *its = &part; its != nullptr && !its->isWindow(); its = its->parentWidget()) {
        const QWidget *around = its->parentWidget();
        if (qobject_cast<const QStackedWidget *>(around) != nullptr ||
            qobject_cast<const QDockWidget *>(around) != nullptr)
            form = its;
    }
    return form;
}

} // namespace

bool isInSameForm(const QWidget &part, const QWidget *other)
{
    return other != nullptr && formOf(part) == formOf(*other);
}

FormFocus::FormFocus(QWidget &field, std::function<void()> left)
    : QObject(&field)
    , m_field(field)
    , m_left(std::move(left))
{
    connect(qApp, &QApplication::focusChanged, this, [this](QWidget *, const QWidget *now) {
        if (now != &m_field && isInSameForm(m_field, now) && !m_field.isAncestorOf(now))
            m_left();
    });
}

} // namespace codewheel
