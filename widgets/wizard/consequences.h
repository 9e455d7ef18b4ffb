// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/layouts.h"
#include "widgets/wizard/setup.h"

#include <QWidget>

class QLabel;

namespace codewheel {

class InlineMessage;

// Below the wanted values: what they lead to, what is wrong with them, and a calculator for finding some.
// Each kind of encoder has its own.
class Consequences : public QWidget
{
    Q_OBJECT

public:
    // For the encoder of the setup.
    static Consequences *make(Setup &setup, QWidget *parent);

    virtual void refresh() = 0;

Q_SIGNALS:
    void chosen(const codewheel::ParameterValues &values); // by the calculator

protected:
    Consequences(Setup &setup, QWidget *parent);

    void tell(const QString &scale, const QString &warning); // empty: none
    void layOut(LayoutPart calculator);

    Setup &m_setup;

private:
    QLabel *m_scale;
    InlineMessage *m_warning;
};

} // namespace codewheel
