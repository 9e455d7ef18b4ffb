// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/input/input_mark.h"

#include "widgets/look/icons.h"
#include "widgets/look/roles.h"

#include <QAction>
#include <QLineEdit>
#include <QToolTip>

namespace codewheel {

InputMark::InputMark(QLineEdit &field)
    : m_field(field)
    , m_mark(field.addAction(lineIcon(Icon::fault, Role::fault), QLineEdit::TrailingPosition))
{
    m_mark->setVisible(false);
}

void InputMark::show(const QString &wrong)
{
    m_mark->setVisible(!wrong.isEmpty());
    m_mark->setToolTip(wrong);
    m_field.setAccessibleDescription(wrong);
}

void InputMark::tellBelow(QWidget &box, const QString &wrong)
{
    if (!box.hasFocus())
        return;
    const QString inLines =
        wrong.isEmpty() ? QString() : QStringLiteral("<qt>%1</qt>").arg(wrong.toHtmlEscaped());
    QToolTip::showText(box.mapToGlobal(QPoint(0, box.height())), inLines, &box); // an empty text hides it
}

} // namespace codewheel
