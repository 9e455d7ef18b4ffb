// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include <functional>

class QWidget;

namespace codewheel {

// Whether both are on the same page or panel of a window, or in the same window that has none.
bool isInSameForm(const QWidget &part, const QWidget *other);

// Tells when the focus goes from a field to another part of its form, which is the page, panel or window it
// is on: then what was typed is taken. Elsewhere, such as to the row of another device, it says nothing: what
// is being typed waits. Belongs to the field.
class FormFocus : public QObject
{
    Q_OBJECT

public:
    FormFocus(QWidget &field, std::function<void()> left);

    void take() { m_left(); } // what is being typed is wanted now

private:
    QWidget &m_field;
    std::function<void()> m_left;
};

} // namespace codewheel
