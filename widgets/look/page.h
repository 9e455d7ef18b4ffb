// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include <utility>

namespace codewheel {

// A page of the main window, in place of the monitors. Provides the texts of its head, and says what would be
// lost if it were closed; whoever shows it then asks.
class Page : public QWidget
{
    Q_OBJECT

public:
    using QWidget::QWidget;

    virtual QString title() const = 0;
    // The encoder or bus it is about; empty: none in particular.
    virtual QString about() const { return m_about; }
    void setAbout(const QString &about)
    {
        if (std::exchange(m_about, about) != about)
            Q_EMIT headChanged();
    }
    virtual QString effect() const = 0; // what it changes and sends, in a sentence
    // A sentence; empty: nothing. Does not count input that is not taken yet.
    virtual QString lostByClosing() const { return {}; }
    // The same of a page whose job runs.
    static QString goesOn() { return tr("What is being written goes on: only Cancel ends it."); }
    // The user has closed it: it starts afresh next time. A running job goes on, and is shown then.
    virtual void leave() {}

Q_SIGNALS:
    void headChanged();
    void closeRequested(); // it has ended by itself

private:
    QString m_about;
};

} // namespace codewheel
