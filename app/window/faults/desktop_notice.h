// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDBusConnection>
#include <QObject>
#include <QStringList>

#include <functional>
#include <optional>

class QDBusMessage;

namespace codewheel {

// The notice of the program on the desktop, by its notification service (org.freedesktop.Notifications): one,
// each replaces the one before. Never waits for the service; without one it does nothing.
class DesktopNotice : public QObject
{
    Q_OBJECT

public:
    explicit DesktopNotice(QObject *parent = nullptr);
    ~DesktopNotice() override;

    struct Text
    {
        QString title;
        QString body;
        bool withSound = false;
    };
    void show(const Text &text);
    void withdraw();

Q_SIGNALS:
    void clicked();
    void staysSilent(); // a sound was wanted, and nobody makes it

private Q_SLOTS:
    void takeAction(uint id, const QString &action);
    void takeToken(uint id, const QString &token);
    void takeEnd(uint id, uint reason);

private:
    using Answer = std::function<void(const QDBusMessage &answer)>; // or an error
    void call(const char *method, const QVariantList &arguments, const Answer &then);
    void goOn();
    void askWhatItCan();
    void send(const Text &text);
    void failed(const Text &text);

    QDBusConnection m_desktop;
    std::optional<QStringList> m_can; // what the service says it can do
    std::optional<Text> m_next;
    bool m_isBusy = false;   // the service is asked something
    bool m_isWanted = false; // not withdrawn since
    uint m_shown = 0;        // as the service numbers it; 0: none
};

} // namespace codewheel
