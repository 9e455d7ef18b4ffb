// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/wizard/setup.h"

#include <QWidget>

namespace codewheel {

// One page of the parameter wizard. Only the page that is shown is notified of what the encoder does.
class WizardPage : public QWidget
{
    Q_OBJECT

public:
    WizardPage(Setup &setup, const QString &title, QWidget *parent = nullptr)
        : QWidget(parent)
        , m_setup(setup)
        , m_title(title)
    {
        setAccessibleName(title);
    }

    const QString &title() const { return m_title; }
    virtual void enter() {} // the page is shown: fill it
    virtual void leave() {} // for the next or previous page: takes what is in its fields
    virtual bool mayGoOn() const { return true; }
    virtual bool mayGoBack() const { return true; }
    virtual QString nextText() const { return tr("&Next"); }

    // Called while the page is shown.
    virtual void showLatest() {}
    virtual void showKnown() {}
    virtual void showPermission() {}
    virtual void showProgress() {}
    virtual void showOutcome(const Outcome &) {}

Q_SIGNALS:
    void changed(); // mayGoOn, mayGoBack, nextText

protected:
    Setup &m_setup;

private:
    QString m_title;
};

} // namespace codewheel
